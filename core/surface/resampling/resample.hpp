// SPDX-License-Identifier: Apache-2.0
// Births and deaths of surfels, which keep the sampling density within bounds (K05 4.3;
// docs/validation/stability.md, row 18).
#pragma once
#include <functional>

#include "core/halo/surface_halos.hpp"
#include "core/surface/advection/reference_motion.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/surface/search/bins.hpp"
#include "core/surface/search/local_surface.hpp"

namespace thaw {

struct SurfaceTools;

/// Result of resampling, the same on all ranks.
struct Resampled {
  std::int64_t births = 0, deaths = 0;
  bool capped = false;    ///< more births were necessary than one call allows
  bool finished = false;  ///< no birth or death remained
};

/// Area law: surfels r apart on a hexagonal lattice have 3.63 (R/r)^2 neighbours within R. The thresholds of
/// K05 are linear in R/r, which leaves holes for R > 2 r.
inline constexpr double neighboursPerArea = 3.6276;
inline constexpr double tooMany = 1.5, tooFew = 0.6;  ///< factors of the area law
/// Strain plus moves (in radii) after which a surfel with correct density is inspected again
/// (Surfels::resampleMargin). Even if the surfel and its neighbour both move this far, a hole of emptyAt
/// stays smaller than a radius.
inline constexpr float fullResampleMargin = 0.1f;
/// Distances over the radius r_s of the surfel.
inline constexpr double emptyAt = 0.8, emptyAtThin = 0.65, crowdedAt = 0.5, crowdedAtMany = 0.7;
/// Distances for surfels with a reference. Surfels of bending solids are not removed, since a later birth
/// could only estimate the lost detail.
inline constexpr double emptyAtSolid = 1.2, crowdedAtSolid = 0.2;

/// Returns whether surfel i may have a birth at this point. surfels: Surface::surfels or a part of it.
/// border: no surfels lie beyond, so the point is extrapolated. May rotate the normal.
using BirthPlace = std::function<bool(const Surfels& surfels, std::size_t i, SurfacePoint& p, bool border)>;

/// Resamples in up to `rounds` rounds, each of which treats independent surfels at once:
/// - Birth: a circle of radius emptyAt * r_s around a surfel lies on the surface. A surfel is born at a
///   point of the circle that has no surfel of its side within that radius. If all circles are covered, holes
///   are smaller than that. With less than tooFew times the neighbours of the area law, the circle is that of
///   emptyAtThin.
/// - Death: surfels closer than crowdedAt radii to one that precedes them (by a hash) die.
///   With more than tooMany times the neighbours of the area law, the distance is that of
///   crowdedAtMany.
///
/// The distance of births exceeds the distance of deaths, so resampling of a static surface ends. Only
/// surfels with Surfels::resampleMargin = 0 are inspected: those in deformed surroundings, new ones, and
/// neighbours of deaths or open rims. Uninspected surfels precede inspected ones. Births interpolate
/// component, colour, detail, temperature and liquid fraction. They require mayBe, or without it, surfels on
/// all sides; birthCap() limits their number in one call. Surfels may be anywhere in any order. They are
/// placed at the end, without ghosts. Uses the tools sort and surfelsOf. Collective.
Resampled resample(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools, std::int64_t rounds,
                   const BirthPlace& mayBe = {});

/// Marks all owned surfels within two of their radii of the flagged rows (owned and ghosts) for inspection.
/// Requires: a table with ghosts and bins.
void markForInspection(Surfels& surfels, const Bins& bins, const std::vector<std::uint8_t>& marked,
                       double spacing);

/// Returns the largest number of births in one call for this number of surfels on all ranks.
inline std::int64_t birthCap(std::int64_t surfels) { return 2000 + surfels; }

}  // namespace thaw
