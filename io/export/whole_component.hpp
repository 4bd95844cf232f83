// A component of a surface in one piece, whatever periodic sides of the domain it crosses.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/output/read_surface_frame.hpp"

namespace thaw {

/// Sides of the domain through which bodies go on at the opposite one.
struct PeriodicSides {
  std::array<bool, 3> is{};  ///< by axis
  Vec3d min{}, period{};     ///< m
  bool any() const { return is[0] || is[1] || is[2]; }
};
PeriodicSides periodicSidesOf(const Domain& domain);

struct WholeComponent {
  std::vector<Vec3d> positions;  ///< m, one a row
  std::array<bool, 3> round{};   ///< by axis: it is joined to its own image along it; positions are then left
                                 ///< in the domain
};

/// Places of the rows of one component, each moved by whole periods so that what is joined across a side lies
/// together, and the mean of all in the domain. Surfels are joined within two radii where their normals
/// agree; parts of a surface that no surfels join (the hollow in a body) are placed beside the nearest one
/// across what is inside. Of surfels that enclose a hollow alone, the body is all around: it goes round on
/// every periodic axis.
WholeComponent wholeComponent(const SurfaceFrame& frame, const std::vector<std::uint32_t>& rows,
                              const PeriodicSides& sides);

}  // namespace thaw
