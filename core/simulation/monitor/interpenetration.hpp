// SPDX-License-Identifier: Apache-2.0
// Detection of interpenetration: oriented particles that have passed into an obstacle or a solid, so that
// contact no longer keeps them on one side.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// An oriented body and a continuum body.
struct Interpenetration {
  std::size_t oriented = 0, body = 0;
  std::int64_t count = 0;  ///< particles of the oriented body, over all ranks
};

/// Returns the oriented particles that are as deep in a solid as its outermost particles. Solid particles of
/// one body then fill more than 0.7 of the kernel around the oriented particle. The value is 0.5 at the
/// surface of the body, and at most 0.3 in regular contact. Also counts particles of a surface that a solid
/// passes through. The same on any number of ranks. Requires: a world between two steps, with the ghosts of
/// the last step. The phase of ghosts is refreshed. Collective.
std::vector<Interpenetration> findInterpenetrations(World& world, Halos halos);

/// Returns free oriented particles more than a quarter of their spacing inside an obstacle. `body` is the
/// wall number of the obstacle. Particles that started inside are included. Collective.
std::vector<Interpenetration> findObstacleInterpenetrations(const OrientedBodies& oriented,
                                                            const Walls& walls, const Scene& scene,
                                                            Reducer& all);

}  // namespace thaw
