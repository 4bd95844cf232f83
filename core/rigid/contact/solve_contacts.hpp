// SPDX-License-Identifier: Apache-2.0
// Impulses of all contacts of rigid pieces in one step.
#pragma once
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/contact/piece_exchange.hpp"
#include "core/rigid/contact/rigid_contact.hpp"

namespace thaw {

struct ContactSettings {
  double step = 0;            ///< s
  double tolerance = 1e-6;    ///< m/s, the iteration stops if no contact has a larger velocity error
  double impactPart = 0;      ///< 1, the same relative to the largest velocity change in an island
  int mostIterations = 500;   ///< iteration limit of each of the two solves
  double impactSpeed = 0;     ///< m/s, twice the speed that gravity adds in a step; slower approaches have no
                              ///< restitution
  double slop = 0;            ///< m, overlap that is not corrected
  double correction = 0.2;    ///< 1, fraction of the overlap beyond slop that is removed in a step
  double mostCorrection = 0;  ///< m, maximum overlap removed in a step
};

struct ContactResult {
  int iterations = 0;            ///< iterations of the velocity solve, maximum over islands
  int correctionIterations = 0;  ///< iterations of the overlap solve, maximum over islands
  double residual = 0;           ///< m/s, largest velocity error of a contact, in the island with the largest
                                 ///< ratio of residual to tolerance
  double tolerance = 0;          ///< m/s, the larger of the two tolerances in that island
  double dissipated = 0;         ///< J, loss of kinetic energy plus the work of obstacles; over all ranks
  double obstacleWork = 0;       ///< J, done by moving obstacles on pieces; over all ranks
  Vec3d obstacleImpulse{};       ///< N s, given to pieces by obstacles; over all ranks
  double deepest = 0;            ///< m, largest overlap, over all ranks
  bool converged = true;         ///< the residual is within the tolerance
};

/// Finds impulses with Signorini's condition, Coulomb's friction cone and Newton's restitution at velocity
/// level. Each island of pieces that touch is solved separately, on one rank (solve_island.hpp). A contact
/// with gap > 0 may close within the step, but not overlap. Displacements without momentum remove overlap.
/// Sets contact impulses, velocity and spin of movable rows, and their changes (one for each row). Requires:
/// step > 0; normals are unit vectors; each contact is given on exactly one rank; keys or normals of contacts
/// differ. Ensures: the bits do not depend on the order of contacts or their ranks. Collective.
ContactResult solveContacts(std::span<PieceMotion> pieces, std::span<RigidContact> contacts,
                            const ContactSettings& settings, PieceExchange& exchange, Reducer& all,
                            std::span<PieceChange> changes);

}  // namespace thaw
