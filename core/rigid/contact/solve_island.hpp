// SPDX-License-Identifier: Apache-2.0
// Impulses of the contacts of an island, by an accelerated Gauss-Seidel iteration.
#pragma once
#include "core/rigid/contact/contact_islands.hpp"
#include "core/rigid/contact/solve_contacts.hpp"

namespace thaw {

struct IslandSolve {
  int iterations = 0;            ///< iterations of the velocity solve
  int correctionIterations = 0;  ///< iterations of the overlap solve
  double residual = 0;           ///< m/s, largest velocity error of a contact in the last iteration
  double tolerance = 0;          ///< m/s
  std::vector<Vec3d> mean;       ///< m/s, relative velocity of each contact, mean of the values before and
                                 ///< after the solve
  std::vector<Vec3d> meanSpin;   ///< rad/s, relative spin, averaged as `mean`; empty without rolling friction
};

/// Sets the contact impulses of an island, and velocity, spin and changes of its rows.
/// Requires: all numbers are finite.
IslandSolve solveIsland(ContactIsland& island, const ContactSettings& settings);

}  // namespace thaw
