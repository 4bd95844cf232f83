// Births and deaths of surfels, so that the surface has no hole and no crowd (K05 4.3;
// docs/validation/stability.md B18).
#pragma once
#include <functional>

#include "core/halo/surface_halos.hpp"
#include "core/surface/bins.hpp"
#include "core/surface/follow_start.hpp"
#include "core/surface/local_surface.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// What resampling has done; the same on all ranks.
struct Resampled {
  std::int64_t births = 0, deaths = 0;
  bool capped = false;    ///< more were wanted than an update may do
  bool finished = false;  ///< nothing was left to do
};

/// The area law: surfels r apart on a hexagonal lattice have 3.63 (R/r)^2 neighbours within R. (K05 has
/// thresholds linear in R/r, which leave holes for R > 2 r.)
inline constexpr double neighboursPerArea = 3.6276;
inline constexpr double tooMany = 1.5, tooFew = 0.6;  ///< times the law
/// A surfel that resampling has found in order is looked at again after this much strain and moves in radii
/// (Surfels::calm): it and its neighbour may each have come so far, and a hole of emptyAt is still none of
/// more than a radius.
inline constexpr float calmFor = 0.1f;
/// of the radius r_s of the surfel
inline constexpr double emptyAt = 0.8, emptyAtThin = 0.65, crowdedAt = 0.5, crowdedAtMany = 0.7;
/// The same of what follows its place at the start. A solid that bends and comes back would lose a mark with
/// each death, and get a guess for it: it has all the surfels that its surface needs, until it is stretched
/// so far that discs no longer meet.
inline constexpr double emptyAtSolid = 1.2, crowdedAtSolid = 0.2;

/// May surfel i (a row of a table that is Surface::surfels or a part of it) have a birth at this point?
/// border: there are no surfels on its other side, so that it follows from nothing but extrapolation. May
/// turn the normal.
using BirthPlace = std::function<bool(const Surfels& surfels, std::size_t i, SurfacePoint& p, bool border)>;

/// Up to `rounds` rounds, each of which lets surfels that are far enough apart act at the same time:
/// - a surfel that has a place on the circle of emptyAt * r_s around it, on the surface between its
/// neighbours, without a surfel of its side
///   within that distance, gets a new one there. If the circle around every surfel is covered, the surface
///   is: so no hole is larger than that. Where there are less than tooFew times the neighbours of the area
///   law, the circle is that of emptyAtThin;
/// - those closer than crowdedAt radii to one that comes first (by a hash) die; likewise those closer than
/// crowdedAtMany where there are
///   more than tooMany times the neighbours of the area law.
/// Births are never closer than what lets one die, so that a surface at rest comes to rest. Only surfels
/// without calm are looked at: those whose surroundings deform, are born, or border on what died or on an
/// open rim; those that keep calm come before the others. New surfels take component, colour, detail,
/// temperature, liquid fraction from around them. Births are where mayBe
/// allows, or without it between surfels, not past a border; no more than birthCap() in one call.
/// Surfels may be anywhere, in any order; at the end they are placed, without ghosts. Tools: sort, surfelsOf.
/// Collective.
Resampled resample(World& world, SurfaceHalos halos, SurfaceTools& tools, std::int64_t rounds,
                   const BirthPlace& mayBe = {});

/// Takes the calm of all owned surfels around (within two of their radii) the marked rows (owned and ghosts),
/// of a table with ghosts in bins.
void disturbAround(Surfels& surfels, const Bins& bins, const std::vector<std::uint8_t>& marked,
                   double spacing);

/// Births that one call may do with this many surfels on all ranks.
inline std::int64_t birthCap(std::int64_t surfels) { return 2000 + surfels; }

}  // namespace thaw
