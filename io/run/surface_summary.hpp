// The surface of a run in summary.json and the lines at the end.
#pragma once
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/surface/start_pieces.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_times.hpp"
#include "io/run/volume_held.hpp"

namespace thaw {

struct SurfaceSummary {
  bool there = false;
  std::int64_t surfels = 0;                    ///< of all ranks
  double spacing = 0;                          ///< m
  std::int64_t lastStep = -1;                  ///< of the last update
  std::int64_t updatesHere = 0;                ///< by this process
  double seconds = 0;                          ///< of them, largest of a rank
  std::array<double, surfacePhases> phases{};  ///< s, of them by phase, largest of a rank
  bool keepsVolume = false;                    ///< the scene wants that
  VolumeHeld held;                             ///< of all frames of the run so far; first rank only
  SurfaceCounters counters;
  std::vector<SurfaceComponent> components;
  std::vector<SurfaceEvent> events;
};

nlohmann::ordered_json surfaceJson(const SurfaceSummary& summary);

/// Counters, how well volumes were held, and the largest components, a line each.
std::vector<std::string> surfaceLines(const SurfaceSummary& summary);

/// Of a start: a line for each body with a label in SurfaceTools::lumps.
std::vector<std::string> lumpWarnings(const Scene& scene, const std::vector<std::uint64_t>& lumps);

/// Of a start: a line for each body in SurfaceTools::pieces.
std::vector<std::string> pieceWarnings(const Scene& scene, const std::vector<BodyPieces>& pieces);

/// In words, with counts.
std::vector<std::string> surfaceWarnings(const SurfaceSummary& summary);

}  // namespace thaw
