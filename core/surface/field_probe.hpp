// The colour field of the particles at any places, up to eight at a time.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "core/surface/bins.hpp"
#include "core/surface/level_table.hpp"
#include "core/surface/surface_kernels.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Pointers and lengths of the sums over particles: all of them but what is asked about, and where the
/// answers go.
ForceSums particleSumsOf(const World& world, const SurfaceTools& tools);

/// The colour field of one component at a place (the sum of readyParticles, 1 deep inside), and what it is on
/// the surface (LevelTable). 1, 1, 1: share of Newton's step, 1/m
struct FieldHere {
  double value = 0, level = 0.5, tight = 1;
  Vec3d gradient{};
};

/// Asks for the colour field with the sums of the iterations. Needs readyParticles.
class FieldProbe {
 public:
  static constexpr std::size_t most = 8;
  FieldProbe(const World& world, const SurfaceTools& tools);
  /// The particles that act on places in a box: those of the component within h_ps of it, in the order of the
  /// bins. Of them those within a cell's edge of `home`, where a particle or surfel of this rank is: farther
  /// off it depends on ranks which there are. For what is asked half a spacing from home or nearer that is
  /// all of them.
  void around(const PlaceBox& box, std::uint64_t component, const Vec3d& home);
  /// Or these rows of them, in that order.
  void among(const std::uint32_t* rows, std::size_t count, std::uint64_t component);
  /// The field at n <= most places among them.
  void at(const Vec3d* x, std::size_t n, FieldHere* found);

 private:
  const World& world_;
  const SurfaceTools& tools_;
  ForceSums sums_;
  double slope_;
  Tightening tight_;
  RowBlock block_;
  std::vector<std::uint32_t> listed_;
  const std::uint32_t* rows_ = nullptr;
  std::size_t count_ = 0;
  alignas(32) std::array<float, 4 * most> place_{};
  alignas(32) std::array<float, most * particleSums> over_{};
};

/// Calls found(row, field) for the owned surfels with asked[row], in any order. Their component's field at
/// their places; uses tools.relax.lists.
void forFieldAtSurfels(const World& world, SurfaceTools& tools, const std::vector<std::uint8_t>& asked,
                       const std::function<void(std::size_t, const FieldHere&)>& found);

}  // namespace thaw
