// SPDX-License-Identifier: Apache-2.0
// Surface of continuum bodies: surfels, components, and data of an update (K05 section 4).
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/surface/data/surfels.hpp"

namespace thaw {

/// Connected body with its surface, as measured at the last update. The same on all ranks, ascending by
/// label.
struct SurfaceComponent {
  std::uint64_t label = noComponent;  ///< 1 + the smallest id of its particles
  std::int64_t particles = 0, surfels = 0;
  double mass = 0;            ///< kg, mass of its particles
  double particleVolume = 0;  ///< m^3, mass / density at rest
  double volume = 0;          ///< m^3, enclosed by the surfels (facets.hpp)
  double area = 0;            ///< m^2
  /// m, centre of mass of its particles; unwrapped across periodic sides, then wrapped into the domain
  /// (measure.hpp)
  Vec3d centroid{};
  /// m, offset of the liquid surface from the colour's level by volume enforcement; part of the state
  double isoOffset = 0;
  /// m^3, target of volume enforcement: volume of its particles times the initial ratio of mesh to particle
  /// volume. Valid in an update
  double targetVolume = 0;
  /// m^2, sum of areas times liquid fractions, which can move as liquid; valid in an update
  double liquidArea = 0;
  /// m^2, sum of areas times frozenShare (surfels.hpp), which can move as frozen surface; valid in an update
  double frozenArea = 0;
  /// m^2, area of surfels on walls, which cannot move outward; valid in an update
  double wallArea = 0;
  /// 1, |sum of the facets' vector areas| / area, 0 for a closed surface; valid in an update
  double open = 0;
};

/// Changes of components. Split: `other` separated from `label`. Merge: two components became `label`, the
/// smaller label. Renamed: the particle with the smallest id of `other` left the domain, or left with a
/// separated part. The component is now `label`.
enum class SurfaceEventKind : std::uint8_t { Split, Merge, Renamed };
inline const char* eventName(SurfaceEventKind kind) {
  return kind == SurfaceEventKind::Split ? "split" : kind == SurfaceEventKind::Merge ? "merge" : "renamed";
}

/// Event, in chronological order, the same on all ranks; part of the state.
struct SurfaceEvent {
  std::int64_t step = 0;
  double time = 0;  ///< s
  SurfaceEventKind kind = SurfaceEventKind::Split;
  std::uint64_t label = 0, other = 0;
};

/// Counts since the start over all ranks. Updates add exact sums, so every rank has the same values.
struct SurfaceCounters {
  std::int64_t updates = 0, iterations = 0, births = 0, deaths = 0, splits = 0, merges = 0;
  std::int64_t lost = 0;         ///< deleted surfels without particles nearby (stability row 15)
  std::int64_t flipped = 0;      ///< normals that pointed against the colour field (stability row 16)
  std::int64_t keptNormals = 0;  ///< kept normals in neighbourhoods without a plane (stability row 23)
  std::int64_t capped = 0;       ///< updates with more births than allowed (stability row 18)
  std::int64_t unfinished = 0;   ///< updates that ended at the largest number of iterations
};

/// Data of a surface on one rank.
struct Surface {
  CellGrid grid;  ///< grid of surfels and particle copies; cell edges are not below any radius of the update
  Surfels surfels;
  CellTable surfelCells;
  SurfaceParticles particles;  ///< empty between updates
  CellTable particleCells;
  double spacing = 0;          ///< m, target distance between surfels, without adaptive density
  double surfelSupport = 0;    ///< m, h_ss
  double particleSupport = 0;  ///< m, h_ps
  std::vector<SurfaceComponent> components;
  std::vector<SurfaceEvent> events;
  std::int64_t changesBefore = 0;  ///< splits and merges before the current update
  SurfaceCounters counters;
  std::int64_t lastStep = -1;  ///< step of the last update
};

/// Returns the margin (m) of surfel lists beyond h_ss. Lists are valid until a surfel has moved by half of
/// the margin.
inline double listMargin(const Surface& s, double particleSpacing) {
  return std::min(2 * s.spacing, particleSpacing);
}

}  // namespace thaw
