// SPDX-License-Identifier: Apache-2.0
// Colour field of the particles at arbitrary positions, up to eight at a time.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/surface/data/level_table.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/kernels/surface_kernels.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

struct SurfaceTools;

/// Returns pointers and lengths for sums over particles. The caller sets the query positions and the output.
ForceSums particleSumsOf(const Scene& scene, const Surface& surface, const SurfaceTools& tools);

/// Colour field (1) of one component at a position (sum of prepareParticles, 1 deep inside), and its gradient
/// (1/m). level: value on the surface there (LevelTable). tight: damping factor of Newton's step.
struct FieldSample {
  double value = 0, level = 0.5, tight = 1;
  Vec3d gradient{};
};

/// Evaluates the colour field with the kernels of the iterations. Requires: prepareParticles.
class FieldProbe {
 public:
  static constexpr std::size_t most = 8;
  FieldProbe(const Scene& scene, const Surface& surface, const SurfaceTools& tools);
  const Scene& scene() const { return scene_; }
  const Surface& surface() const { return surface_; }
  /// Selects the particles that act on positions in a box: particles of the component within h_ps of it, in
  /// the order of the bins. `ownPosition` (m) is the position of an owned particle or surfel. Only particles
  /// within a cell's edge of it count, because farther ghosts depend on the ranks. For positions within half
  /// a spacing of `ownPosition`, no particle is missing.
  void around(const PlaceBox& box, std::uint64_t component, const Vec3d& ownPosition);
  /// Selects these rows, in their order.
  void selectRows(const std::uint32_t* rows, std::size_t count, std::uint64_t component);
  /// Evaluates the field at n <= most positions (m).
  void at(const Vec3d* x, std::size_t n, FieldSample* found);

 private:
  const Scene& scene_;
  const Surface& surface_;
  const SurfaceTools& tools_;
  ForceSums sums_;
  double slope_;
  LevelRise tight_;
  RowBlock block_;
  std::vector<std::uint32_t> listed_;
  const std::uint32_t* rows_ = nullptr;
  std::size_t count_ = 0;
  alignas(32) std::array<float, 4 * most> place_{};
  alignas(32) std::array<float, most * particleSums> over_{};
};

/// Calls found(row, field) for the owned surfels with asked[row], in any order. field: field of the surfel's
/// component at its position. Uses tools.relax.lists.
void forFieldAtSurfels(const Scene& scene, const Surface& surface, SurfaceTools& tools,
                       const std::vector<std::uint8_t>& probed,
                       const std::function<void(std::size_t, const FieldSample&)>& found);

}  // namespace thaw
