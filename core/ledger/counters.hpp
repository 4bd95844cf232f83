// SPDX-License-Identifier: Apache-2.0
// Counters of a run.
#pragma once
#include <cstdint>

namespace thaw {

/// Counts of problems and corrections, for progress lines and the summary. Sums over ranks are exact.
struct Counters {
  std::int64_t singularNeighbourhoods = 0;  ///< particles whose moment matrix had rank < 3 when it was last
                                            ///< computed
  std::int64_t brokenBonds = 0;
  std::int64_t inverted = 0;           ///< particles with det F <= 0 (particle-steps)
  std::int64_t softenedParticles = 0;  ///< particles compressed so far that the law "green" weakens
                                       ///< (particle-steps)
  std::int64_t coincidentPairs = 0;
  std::int64_t melted = 0, frozen = 0;  ///< phase changes
  std::int64_t welds = 0;
  std::int64_t rereferenced = 0;
  std::int64_t wallProjections = 0;  ///< particles projected out of an obstacle
  std::int64_t left = 0, emitted = 0;
  std::int64_t evaporated = 0;          ///< particles that left as vapour
  std::int64_t leftThrough[3][2] = {};  ///< particles that left through open sides, [axis][low, high]; at a
                                        ///< corner, the side with the largest distance counts
  std::int64_t viscousIterations = 0;   ///< iterations of the implicit viscosity, all steps; on the first
                                        ///< rank only
  std::int64_t viscousUnfinished = 0;   ///< steps in which implicit viscosity did not converge; on the first
                                        ///< rank only
  std::int64_t retries = 0;             ///< failed stretches of steps that were repeated with shorter steps
  std::int64_t densityIterations = 0, divergenceIterations = 0;  ///< incompressible solver; on the
                                                                 ///< first rank only
  std::int64_t orientedBirths = 0, orientedDeaths = 0;
  std::int64_t crowded = 0;    ///< liquid particles whose summed density far exceeded the carried density in
                               ///< the last step
  std::int64_t connected = 0;  ///< liquid particles with at least two neighbours, in the last step with
                               ///< carried densities
  std::int64_t connectedDensity = 0;   ///< 1e-6, sum of their summed relative densities
  std::int64_t sleeping = 0;           ///< particles whose sums were skipped in the last step
  std::int64_t unsolvedPressures = 0;  ///< solves that reached the iteration limit; on the first rank only
  std::int64_t contactIterations = 0;  ///< iterations of contacts of rigid pieces, all steps; on the first
                                       ///< rank only
  std::int64_t contactUnfinished = 0;  ///< steps in which contacts of rigid pieces did not converge; on the
                                       ///< first rank only
  std::int64_t impactsUnfinished = 0;  ///< elastic solves of impacts that did not converge; on the first rank
                                       ///< only
  std::int64_t brokenPieces = 0;       ///< rigid pieces that broke; on the first rank only
  std::int64_t weldedPieces = 0;       ///< rigid pieces that joined others; on the first rank only
};

/// Iterations of the incompressible solver in the last step, equal on all ranks; not part of the state.
struct PressureIterations {
  std::int64_t density = 0, divergence = 0;
};

}  // namespace thaw
