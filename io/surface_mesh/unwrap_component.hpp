// SPDX-License-Identifier: Apache-2.0
// Unwrapping of a surface component across periodic sides of the domain.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/frames/read_surface_frame.hpp"

namespace thaw {

/// Periodic sides of the domain.
struct PeriodicSides {
  std::array<bool, 3> is{};  ///< per axis
  Vec3d min{}, period{};     ///< m
  bool any() const { return is[0] || is[1] || is[2]; }
};
PeriodicSides periodicSidesOf(const Domain& domain);

struct UnwrappedComponent {
  std::vector<Vec3d> positions;      ///< m, one per row
  std::array<bool, 3> selfJoined{};  ///< per axis: joined to its own image; positions then stay in the domain
};

/// Returns the positions of a component's rows, moved by whole periods so that neighbours across sides lie
/// together and the mean is in the domain. Surfels are joined within two radii if their normals agree.
/// Separate surfaces (a hollow in a body) are placed by the nearest pair across the inside. If the surfels
/// enclose only a hollow, the body extends through all periodic axes.
UnwrappedComponent unwrapComponent(const SurfaceFrame& frame, const std::vector<std::uint32_t>& rows,
                                   const PeriodicSides& sides);

}  // namespace thaw
