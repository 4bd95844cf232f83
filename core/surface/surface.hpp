// The surface of continuum bodies: surfels, their components, and what an update works with (K05 section 4).
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/surface/surfels.hpp"

namespace thaw {

/// A connected body with its surface, as measured at the last update. The same on all ranks, ascending by
/// label.
struct SurfaceComponent {
  std::uint64_t label = noComponent;  ///< 1 + the smallest id of its particles
  std::int64_t particles = 0, surfels = 0;
  double mass = 0;            ///< kg, of its particles
  double particleVolume = 0;  ///< m^3, mass / density at rest
  double volume = 0;          ///< m^3, enclosed by the surfels (facets.hpp)
  double area = 0;            ///< m^2
  Vec3d centroid{};   ///< m, of its particles by mass; across periodic sides in one piece, and put into the
                      ///< domain (measure.hpp)
  double raised = 0;  ///< m, how far volume keeping holds what is liquid of it off the level of the
                      ///< particles' colour; part of the state
  double wantedVolume = 0;  ///< m^3, that volume keeping holds: of its particles, times what their body's
                            ///< mesh held over that at the start; of the update
  double freeArea = 0;   ///< m^2, sum of the surfels' areas times their liquid fractions: what volume keeping
                         ///< may move; of the update
  double plainArea = 0;  ///< m^2, the same times their frozenShare (surfels.hpp): what it may move of what
                         ///< has frozen; of the update
  double heldArea = 0;   ///< m^2, of the surfels that lie on walls: they cannot move out; of the update
  double open = 0;       ///< |sum of the facets' vector areas| / area: 0 where the surface is closed; of the
                         ///< update
};

/// What happens to components. Split: `other` came off `label`. Merge: two became `label`, which is the
/// smaller one. Renamed: its smallest particle has gone (it left the domain, or came off with a piece), so
/// that what was called `other` is `label` now.
enum class SurfaceEventKind : std::uint8_t { Split, Merge, Renamed };
inline const char* eventName(SurfaceEventKind kind) {
  return kind == SurfaceEventKind::Split ? "split" : kind == SurfaceEventKind::Merge ? "merge" : "renamed";
}

/// In the order in which they happened, the same on all ranks; part of the state.
struct SurfaceEvent {
  std::int64_t step = 0;
  double time = 0;  ///< s
  SurfaceEventKind kind = SurfaceEventKind::Split;
  std::uint64_t label = 0, other = 0;
};

/// Counted since the start, of all ranks: an update adds exact sums, so that every rank has the same figures.
struct SurfaceCounters {
  std::int64_t updates = 0, iterations = 0, births = 0, deaths = 0, splits = 0, merges = 0;
  std::int64_t lost = 0;         ///< surfels without particles around, deleted (B15)
  std::int64_t flipped = 0;      ///< normals that stood against the colour field (B16)
  std::int64_t keptNormals = 0;  ///< neighbourhoods without a plane: the old normal kept (B23)
  std::int64_t capped = 0;       ///< updates that reached the cap on births and deaths (B18)
  std::int64_t unfinished = 0;   ///< updates that ended at the largest number of iterations
};

/// All of a surface on one rank.
struct Surface {
  CellGrid grid;  ///< of surfels and particle copies: edge >= every radius of the update
  Surfels surfels;
  CellTable surfelCells;
  SurfaceParticles particles;  ///< empty between updates
  CellTable particleCells;
  double spacing = 0;          ///< m, wanted distance of surfels where nothing asks for less
  double surfelSupport = 0;    ///< m, h_ss
  double particleSupport = 0;  ///< m, h_ps
  std::vector<SurfaceComponent> components;
  std::vector<SurfaceEvent> events;
  std::int64_t changesBefore = 0;  ///< splits and merges before the update under way
  SurfaceCounters counters;
  std::int64_t lastStep = -1;  ///< of the last update
};

/// m, by how much lists of surfels reach farther than h_ss, so that they hold until one has come half as far.
inline double listMargin(const Surface& s, double particleSpacing) {
  return std::min(2 * s.spacing, particleSpacing);
}

}  // namespace thaw
