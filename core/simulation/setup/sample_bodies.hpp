// SPDX-License-Identifier: Apache-2.0
// Sampling of the scene's bodies at time 0.
#pragma once
#include <string>
#include <vector>

#include "core/domain/outside.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/shapes/overlap.hpp"
#include "core/halo/halo.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Results of sampling, summed over ranks.
struct SamplingReport {
  std::vector<std::int64_t> particles;  ///< by body
  std::vector<std::int64_t> clamped;    ///< clamped particles, by body
  std::vector<double> volume;           ///< m^3, of particles, by body
  std::vector<BodyOverlap> overlaps;
  std::int64_t removed = 0;      ///< number of samples removed by the scene's overlap rule
  std::vector<Outside> outside;  ///< extent outside of the domain, by body
  std::int64_t inObstacles = 0;
  std::string firstObstacle;           ///< names of the first body in an obstacle and of the obstacle, for
                                       ///< the message
  SourcePlace obstacleWhere;           ///< location in the scene of the first body in an obstacle
  std::vector<SceneWarning> warnings;  ///< about narrow bodies, oriented bodies and sheets, and repairs of
                                       ///< meshes
};

/// Appends this rank's part of all bodies' particles. The rows of each body's lattice are distributed evenly
/// over ranks. Ids consist of the body's number and the index in its lattice, the same on any number of
/// ranks. Overlaps follow the scene's rule; the caller handles OverlapRule::Error. Collective.
SamplingReport sampleBodies(World& world, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                            Reducer& all);

}  // namespace thaw
