// SPDX-License-Identifier: Apache-2.0
// The surface in summary.json and in the last lines of a run.
#pragma once
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/data/surface_times.hpp"
#include "core/surface/start_pieces.hpp"
#include "io/run/reports/volume_errors.hpp"

namespace thaw {

struct SurfaceSummary {
  bool there = false;
  std::int64_t surfels = 0;                    ///< sum over ranks
  double spacing = 0;                          ///< m
  std::int64_t lastStep = -1;                  ///< step of the last update
  std::int64_t updatesHere = 0;                ///< updates by this process
  double seconds = 0;                          ///< s, of these updates, largest over ranks
  std::array<double, surfacePhases> phases{};  ///< s, by phase, largest over ranks
  bool keepsVolume = false;                    ///< the scene sets surface.enforce_volume
  VolumeErrors volumeErrors;                   ///< over all frames of the run so far; first rank only
  SurfaceCounters counters;
  std::vector<SurfaceComponent> components;
  std::vector<SurfaceEvent> events;
};

nlohmann::ordered_json surfaceJson(const SurfaceSummary& summary);

/// Returns lines with counters, volume errors, and the largest components.
std::vector<std::string> surfaceLines(const SurfaceSummary& summary);

/// Returns a line for each body with a label in SurfaceTools::mergedSheets, at a start.
std::vector<std::string> mergedSheetWarnings(const Scene& scene,
                                             const std::vector<std::uint64_t>& mergedSheets);

/// Returns a line for each body in SurfaceTools::pieces, at a start.
std::vector<std::string> pieceWarnings(const Scene& scene, const std::vector<BodyPieces>& pieces);

/// Returns warnings with counts.
std::vector<std::string> surfaceWarnings(const SurfaceSummary& summary);

}  // namespace thaw
