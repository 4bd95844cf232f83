// Particles of the scene's bodies at time 0.
#pragma once
#include <string>
#include <vector>

#include "core/domain/outside.hpp"
#include "core/geometry/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/kinds/start_warnings.hpp"
#include "core/world.hpp"

namespace thaw {

/// What was found while sampling, summed over ranks.
struct SamplingReport {
  std::vector<std::int64_t> particles;  ///< by body
  std::vector<std::int64_t> clamped;    ///< of them, by body
  std::vector<std::string> overlaps;    ///< a sentence for each pair of bodies that overlap, with the counts
  std::int64_t removed = 0;             ///< samples left out of them, as the scene says
  std::vector<Outside> outside;         ///< of the domain, by body
  std::int64_t inObstacles = 0;
  std::string firstObstacle;                ///< names, for the message
  SourcePlace overlapWhere, obstacleWhere;  ///< of the first body concerned
  std::vector<SceneWarning> warnings;  ///< of narrow bodies, of oriented bodies and sheets; what was mended
                                       ///< of meshes
};

/// Appends this rank's share of all bodies' particles: the rows of each body's lattice are dealt out evenly,
/// so that no rank samples more than its part. Ids are the body's number and the place in its lattice, the
/// same on any number of ranks. Overlaps are handled as the scene says; OverlapRule::Error is left to the
/// caller. Collective.
SamplingReport sampleBodies(World& world, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                            Reducer& all);

}  // namespace thaw
