// SPDX-License-Identifier: Apache-2.0
// Accelerated projected gradient iteration over contact impulses.
#pragma once
#include <span>
#include <vector>

#include "core/rigid/contact/contact_system.hpp"

namespace thaw {

/// Conditions of all contacts.
struct ContactConditions {
  std::span<const Vec3d> free;     ///< m/s, relative velocity of each contact without impulses
  std::span<const double> target;  ///< m/s, least relative normal velocity of each contact
  bool friction = true;            ///< false: impulses are normal
  double tolerance = 0;            ///< m/s
  int mostIterations = 0;
};

struct SolveCount {
  int iterations = 0;
  double residual = 0;  ///< m/s, largest over all ranks
};

/// Improves the impulses (N s; in: a guess) until every contact fulfils u_n >= target, with impulse_n >= 0,
/// complementarity, and Coulomb's cone. rows (out): changes of the rows by the impulses. Collective.
///
/// Nesterov's iteration [N83] with restarts where the gradient opposes the step [OC15]. The step length
/// follows Rayleigh quotients of the steps taken. It is bounded by that of mass splitting, which always
/// converges without friction.
SolveCount solveAccelerated(ContactSystem& system, const ContactConditions& conditions,
                            std::span<Vec3d> impulses, std::vector<RowChange>& rows);

}  // namespace thaw
