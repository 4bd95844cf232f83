// SPDX-License-Identifier: Apache-2.0
// Force and torque of the particles on one obstacle, for programs that move it.
#pragma once
#include "core/math/exact_sum.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Sums over the particles of this rank.
struct WallLoad {
  ExactSum force[3];   ///< N
  ExactSum torque[3];  ///< N m, about the moved origin of the obstacle
};

/// Returns the reaction to the forces of a wall and of its images: pressure, drag, surface tension of 90
/// degrees, and contact. wall: index in Walls::list of an original. It has no side effects, so only
/// programs that read loads pay for them. Contacts that act in substeps contribute their force at the end of
/// the step. Requires: densities and contacts of the current positions; explicit pressure and viscosity.
WallLoad wallLoad(const WallContext& context, double inverseLatticeSum, const WallContacts& contacts,
                  std::size_t wall);

}  // namespace thaw
