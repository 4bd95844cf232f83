// SPDX-License-Identifier: Apache-2.0
// Whole surface updates (updateSurface) of the bust of scenes/keiser/melting_fast.toml, on one core.
#pragma once
#include <cstdint>

namespace thaw {

struct WholeUpdates {
  double particles = 0, surfels = 0, surfelNeighbours = 0;
  double seconds = 0, worst = 0;        ///< processor time (s): mean and maximum of an update
  double startSeconds = 0;              ///< processor time (s) of startSurface
  double phase[8]{};                    ///< s per update, wall clock, by SurfacePhase
  double iterations = 0, finished = 0;  ///< mean number; fraction of updates that reached the local stop
  std::int64_t updates = 0;
};

/// Runs `updates` updates of the scene's 4,000 particles with about `surfels` surfels, after three uncounted
/// ones. Solid: the bust turns by 1/50 of a turn and falls between updates. Molten: it is liquid below 0.6 of
/// its height and partly liquid up to 0.7, and sinks and spreads there. The flow conserves volume: x' = x/2,
/// y' = y/2, z' = -z, times a smooth factor. It moves at most a quarter of a support radius between updates.
/// support: h_ss over the spacing of surfels (SurfaceSettings::support).
WholeUpdates wholeUpdates(bool molten, double surfels, double support, std::int64_t updates);

}  // namespace thaw
