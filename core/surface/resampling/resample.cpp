// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/hash_random.hpp"
#include "core/surface/advection/reference_motion.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/data/surfel_ids.hpp"
#include "core/surface/measures/small_drops.hpp"
#include "core/surface/resampling/adapt_density.hpp"
#include "core/surface/resampling/births.hpp"
#include "core/surface/resampling/sampling_density.hpp"
#include "core/surface/search/active_set.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

// LocalMaximum: precedes all surfels that are too close to it
enum ResampleFlag : std::uint8_t { Birth = 1, Crowded = 2, LocalMaximum = 4, Changed = 8 };

/// Returns whether a surfel next to melt still has its full mesh detail.
bool carriesDetail(const Surfels& s, std::size_t i) {
  return s.maxLiquidFraction.active && s.detail[i] > 0.9f && s.liquid[i] < 0.05f;
}

// rad, 206 degrees
constexpr double border = 3.6;
/// Value of Surfels::resampleMargin within a call, after a refused birth at a rim. Changes nearby reset it.
constexpr float refused = -1;
struct Round {
  Surfels* table;
  const RowLists& lists;
  double reach;  ///< m, radius of the lists
  std::uint64_t seed, salt;
  const BirthPlace& mayBe;
  bool start;  ///< nothing has moved yet
  const Bins& bins;
  double particleSpacing;  ///< m
  bool adapts;             ///< the first round with adaptive density
  std::int64_t surfels;    ///< number on all ranks before the first round; 0 in the first round
  std::vector<std::uint64_t> birthOrder{}, deathOrder{};  ///< for all rows, ghosts included
  std::vector<float> closest{};                           ///< for owned rows
  /// by row, ghosts included: true if inspected in this round
  std::vector<std::uint8_t> open{};

  void flagOpen() {
    open.resize(table->size());
    for (std::size_t i = 0; i < table->size(); i++) open[i] = table->resampleMargin[i] == 0;
  }
  /// Returns the number of open surfels on all ranks. Collective.
  std::int64_t openRows(Reducer& all) const {
    std::int64_t n[1] = {
        std::count(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(table->owned), 1)};
    all.sum(n);
    return n[0];
  }

  void drawOrder() {
    Surfels& s = *table;
    birthOrder.resize(s.size());
    deathOrder.resize(s.size());
    for (std::size_t i = 0; i < s.size(); i++) {
      if (!open[i]) continue;
      birthOrder[i] = randomBits(seed, Purpose::SurfelBirth, s.id[i], salt);
      deathOrder[i] = randomBits(seed, Purpose::SurfelDeath, s.id[i], salt);
    }
  }

  /// Sets the flags and birth candidates of the inspected surfels. After a refused birth, a surfel is ignored
  /// until its surroundings change.
  void findCandidates() {
    Surfels& s = *table;
    drawOrder();
    closest.resize(s.owned);
    Patch patch;
    for (std::size_t i = 0; i < s.owned; i++) {
      s.resampleFlags[i] = 0;
      s.candidateOffset[i] = {};
      if (!open[i]) continue;
      const double circle = std::min(3 * s.radius[i], reach);
      patch.gather(s, i, lists, circle);
      const SamplingDensity c = samplingDensityOf(patch, circle);
      closest[i] = static_cast<float>(c.closest);
      bool first = true;
      for (const std::uint32_t j : patch.rows)
        first = first && !(tooClose(s, i, j, c.closest) && (!open[j] || before(deathOrder, j, i)));
      if (first) s.resampleFlags[i] |= LocalMaximum;
      if (c.crowded) {
        s.resampleFlags[i] |= Crowded;
        continue;
      }
      s.resampleMargin[i] = fullResampleMargin;
      patch.fitCurvature();
      std::optional<SurfacePoint> place = uncoveredPoint(
          patch, ((hasReference(s, i) || (!start && carriesDetail(s, i))) && !atSeam(patch) ? emptyAtSolid
                  : c.thin                                                                  ? emptyAtThin
                                                                                            : emptyAt) *
                     s.radius[i]);
      if (!place) continue;
      if (hasReference(s, i) && !stretched(patch)) {
        s.resampleMargin[i] = refused;
        continue;
      }
      const bool beyond = widestGap(patch, *place, 2 * s.radius[i]) > border;
      // A rim stays under inspection, because the body may continue there.
      s.resampleMargin[i] = 0;
      if ((beyond || liquidShare(s, i) < 0.5) && hasParallelSheet(i, *place, beyond)) {
        s.resampleMargin[i] = refused;
        continue;
      }
      if ((mayBe ? !mayBe(s, i, *place, beyond) : beyond) || taken(i, *place)) {
        s.resampleMargin[i] = refused;
        continue;
      }
      s.resampleFlags[i] |= Birth;
      s.candidateOffset[i] = place->position - s.position[i];
      s.candidateNormal[i] = place->normal;
    }
  }

  /// Returns whether surfels with and without reference meet in the patch. A step may form there, with gaps
  /// between adjacent discs as seen from the side.
  bool atSeam(const Patch& patch) const {
    const Surfels& s = *table;
    const double far = 2.5 * s.radius[patch.centre];
    return std::any_of(patch.rows.begin(), patch.rows.end(), [&](std::uint32_t j) {
      const Vec3d d = s.position[j] - s.position[patch.centre];
      return hasReference(s, j) != hasReference(s, patch.centre) && dot(d, d) < far * far;
    });
  }

  /// Returns whether a neighbour is farther from the centre than in the reference, or has none. If not, an
  /// apparent hole is the crease of a closing groove, whose faces do not interact.
  bool stretched(const Patch& patch) const {
    constexpr double least = 1.15;
    const Surfels& s = *table;
    const std::size_t i = patch.centre;
    const double far = 2.5 * s.radius[i];
    for (const std::uint32_t j : patch.rows) {
      if (!hasReference(s, j)) return true;
      const Vec3d now = s.position[j] - s.position[i], then = s.referencePosition[j] - s.referencePosition[i];
      if (dot(then, then) < far * far && dot(now, now) > least * least * dot(then, then)) return true;
    }
    return false;
  }

  /// Returns true if a surfel on the same side is so near that one of the two would die. Also returns true if
  /// a sheet of the same orientation lies directly above or below. Neither particles nor a gap fit between
  /// two such sheets, and a second skin would grow.
  bool taken(std::size_t i, const SurfacePoint& p) const {
    constexpr double sameWay = 0.5, beside = 0.4;
    const Surfels& s = *table;
    const double least = crowdedAtMany * s.radius[i], column = beside * s.radius[i];
    for (std::uint64_t k = lists.first[i]; k < lists.end[i]; k++) {
      const std::uint32_t j = lists.row[k];
      const Vec3d d = s.position[j] - p.position;
      const double d2 = dot(d, d), facing = dot(s.normal[j], p.normal);
      if (!(facing > oneSide) || s.component[j] != s.component[i]) continue;
      if (d2 < least * least) return true;
      const double along = dot(d, p.normal);
      if (facing > sameWay && d2 - along * along < column * column) return true;
    }
    return false;
  }

  /// Returns whether a sheet of the same orientation lies above or below, within a particle spacing. Beyond a
  /// rim, the body's colour bridges grooves, above the groove's own sheet. Between surfels of solids, a
  /// second sheet would continue to grow around the first. Sheets bent by less than 45 degrees do not count.
  bool hasParallelSheet(std::size_t i, const SurfacePoint& p, bool beyond) const {
    const double sameWay = beyond ? 0.3 : 0.7;
    constexpr double beside = 0.8;
    const Surfels& s = *table;
    bool over = false;
    forRowsAround(bins, p.position, p.position, particleSpacing, [&](std::uint32_t j, const Vec3d& at) {
      const Vec3d d = at - p.position;
      const double along = dot(d, p.normal), d2 = dot(d, d), column = beside * s.radius[j];
      over = over || (d2 < particleSpacing * particleSpacing && std::abs(along) > s.radius[i] &&
                      d2 - along * along < column * column && s.component[j] == s.component[i] &&
                      dot(s.normal[j], p.normal) > sameWay);
    });
    return over;
  }

  bool before(const std::vector<std::uint64_t>& order, std::size_t i, std::size_t j) const {
    const Surfels& s = *table;
    return order[i] != order[j] ? order[i] > order[j] : s.id[i] > s.id[j];
  }

  /// Returns whether a surfel gives birth. Of conflicting births only the first happens.
  bool givesBirth(std::size_t i) const {
    const Surfels& s = *table;
    if (!(s.resampleFlags[i] & Birth)) return false;
    const Vec3d here = s.position[i] + s.candidateOffset[i];
    for (std::uint64_t k = lists.first[i]; k < lists.end[i]; k++) {
      const std::uint32_t j = lists.row[k];
      if (!(s.resampleFlags[j] & Birth) || s.component[j] != s.component[i]) continue;
      const Vec3d d = s.position[j] + s.candidateOffset[j] - here;
      const double r = std::max(s.radius[i], s.radius[j]);
      if (dot(d, d) < r * r && before(birthOrder, j, i)) return false;
    }
    return true;
  }

  /// Returns whether a surfel dies. A local maximum stays, and surfels too close to it die.
  bool dies(std::size_t i) const {
    const Surfels& s = *table;
    if (!(s.resampleFlags[i] & Crowded)) return false;
    for (std::uint64_t k = lists.first[i]; k < lists.end[i]; k++) {
      const std::uint32_t j = lists.row[k];
      if ((!open[j] || (s.resampleFlags[j] & LocalMaximum)) && s.component[j] == s.component[i] &&
          dot(s.normal[j], s.normal[i]) > oneSide && tooClose(s, i, j, static_cast<double>(closest[i])) &&
          (!(s.resampleFlags[j] & Crowded) || before(deathOrder, j, i)))
        return true;
    }
    return false;
  }

  std::vector<SurfelRow> births(const std::vector<std::uint32_t>& parents) const {
    const Surfels& s = *table;
    std::vector<SurfelRow> born;
    Patch patch;
    for (const std::uint32_t i : parents) {
      patch.gather(s, i, lists, std::min(3 * s.radius[i], reach));
      born.push_back(blendedSurfel(patch, {s.position[i] + s.candidateOffset[i], s.candidateNormal[i]}));
      born.back().id = surfelBit | birthBit | randomBits(seed, Purpose::SurfelBirth, s.id[i], ~salt);
    }
    return born;
  }
};

/// Returns a salt for each round of each call in a step, so repeated births of a surfel have different ids.
/// Calls in one step differ by the number of earlier births, unless no births occurred.
std::uint64_t saltOf(const SurfaceView& w, const Resampled& done, std::int64_t round) {
  const std::int64_t births = w.surface.counters.births + done.births;
  return randomBits(w.scene.seed, Purpose::SurfelSample, static_cast<std::uint64_t>(w.clock.step),
                    static_cast<std::uint64_t>(births) << 8 | static_cast<std::uint64_t>(round));
}

/// Moves radii towards the surfel spacing, without adaptive density. Surfels of a small drop have smaller
/// radii and may now belong to a large body.
void relaxRadii(Surface& surface) {
  Surfels& s = surface.surfels;
  SmallDrops small(surface);
  for (std::size_t i = 0; i < s.owned; i++) {
    const double off = surface.spacing - s.radius[i];
    if (!(std::abs(off) > 0.1 * s.radius[i]) || small(s.component[i])) continue;
    s.radius[i] += 0.5 * off;
    s.resampleMargin[i] = 0;
  }
}

/// Excludes small drops, which are spheres (renewSurfels), from resampling.
void excludeSmallDrops(const Surface& surface, Surfels& s) {
  SmallDrops small(surface);
  for (std::size_t i = 0; i < s.owned; i++)
    if (small(s.component[i])) s.resampleMargin[i] = fullResampleMargin;
}

std::int64_t countOpen(const Surfels& s, Reducer& all) {
  std::int64_t open[1] = {std::count_if(s.resampleMargin.data(), s.resampleMargin.data() + s.owned,
                                        [](float resampleMargin) { return resampleMargin == 0; })};
  all.sum(open);
  return open[0];
}

/// Places the surfels of a round, with ghosts and bins, and flags the open ones.
void placeOpen(Surface& surface, SurfaceHalos halos, SurfaceTools& t, ActiveSet& region, Round& r) {
  Surfels& s = *r.table;
  CellTable& cells = region.taken ? region.cells : surface.surfelCells;
  placeRows(surface.grid, halos.surfels, s, cells, t.sort);
  ColumnList columns{&s.id,           &s.position,   &s.normal,         &s.radius, &s.component,
                     &s.colour,       &s.detail,     &s.resampleMargin, &s.liquid, &s.maxLiquidFraction,
                     &s.detailHeight, &s.temperature};
  if (s.hasReference.active)
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&s.hasReference, &s.tangent, &s.referencePosition,
                                                          &s.referenceNormal, &s.referenceTangent})
      columns.push_back(c);
  addGhosts(halos.surfels, s, cells, columns);
  fillBins(surface.grid, cells, s.position.data(), r.reach, t.relax.surfelBins);
  r.flagOpen();
}

double leastEdge(const CellGrid& grid) { return std::min({grid.edge.x, grid.edge.y, grid.edge.z}); }

/// Places the surfels of a round, adapts their density in the first, and lists the surroundings of open ones.
/// With few open surfels, the round and later ones use the active set. Collective.
void beginRound(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t, Round& r) {
  Surface& surface = w.surface;
  Surfels& all = surface.surfels;
  ActiveSet& region = t.activeSet;
  placeOpen(surface, halos, t, region, r);
  if (r.adapts) {
    r.open.assign(all.size(), 1);
    findRows(t.relax.surfelBins, all.position.data(), all.owned, r.open, r.reach, t.surfelsOf);
    adaptDensity(surface, halos.surfels, t.surfelsOf, r.reach, w.scene.surface.adapt * surface.spacing);
    r.flagOpen();
    return;
  }
  const double regionRadius = std::min(3 * r.reach, leastEdge(surface.grid));
  if (r.surfels > 0 && !region.taken && regionRadius >= 2 * r.reach && region.few > 0 &&
      r.openRows(halos.all) * region.few < r.surfels) {
    extractActiveSet(surface, t.relax.surfelBins, r.open, regionRadius, r.reach, region);
    r.table = &region.surfels;
    placeOpen(surface, halos, t, region, r);
  }
  findRows(t.relax.surfelBins, r.table->position.data(), r.table->owned, r.open, r.reach, t.surfelsOf);
}

/// Births and deaths of a round.
struct RoundChanges {
  std::vector<std::uint32_t> parents, stay, dead;    ///< owned rows
  std::int64_t surfels = 0, births = 0, deaths = 0;  ///< on all ranks
};

/// Collective.
RoundChanges selectChanges(const Round& r, Reducer& all) {
  RoundChanges c;
  for (std::uint32_t i = 0; i < r.table->owned; i++) {
    if (r.givesBirth(i)) c.parents.push_back(i);
    (r.dies(i) ? c.dead : c.stay).push_back(i);
  }
  std::array<std::int64_t, 3> count{static_cast<std::int64_t>(r.table->owned),
                                    static_cast<std::int64_t>(c.parents.size()),
                                    static_cast<std::int64_t>(c.dead.size())};
  all.sum(count);
  c.surfels = count[0], c.births = count[1], c.deaths = count[2];
  return c;
}

/// Limits births to a fraction, selected by hash, and reduces the fraction further if births are still too
/// many. Returns whether there were more than `most`. Collective.
bool limitBirths(const Round& r, std::int64_t most, RoundChanges& c, Reducer& all) {
  bool limited = false;
  for (double fraction = 1; c.births > most;) {
    fraction *= 0.98 * static_cast<double>(most) / static_cast<double>(c.births);
    std::erase_if(c.parents, [&](std::uint32_t i) {
      return randomUniform(r.seed, Purpose::SurfelSample, r.table->id[i], r.salt) >= fraction;
    });
    c.births = static_cast<std::int64_t>(c.parents.size());
    all.sum({&c.births, 1});
    limited = true;
  }
  return limited;
}

/// Marks surfels around births and deaths for inspection. Deaths may uncover surface, and births change the
/// patches of their neighbours. Collective.
void inspectAround(const RoundChanges& c, double spacing, SurfaceHalos halos, Round& r) {
  Surfels& s = *r.table;
  for (const std::uint32_t i : c.dead) s.resampleFlags[i] |= Changed;
  for (const std::uint32_t i : c.parents) s.resampleFlags[i] |= Changed;
  refreshGhosts(halos.surfels, s, ColumnList{&s.resampleFlags});
  std::vector<std::uint8_t> changed(s.size());
  for (std::size_t i = 0; i < s.size(); i++) changed[i] = (s.resampleFlags[i] & Changed) != 0;
  markForInspection(s, r.bins, changed, spacing);
}

/// Removes the dead surfels and adds the new ones. Collective.
void applyChanges(Surface& surface, const RoundChanges& c, const ActiveSet& region, const Round& r,
                  Reducer& all) {
  Surfels& s = *r.table;
  const std::vector<SurfelRow> born = r.births(c.parents);
  std::vector<double> depth;
  for (const std::uint32_t i : c.parents)
    depth.push_back(region.taken ? s.depth[i] + length(s.candidateOffset[i]) : 0);
  s.resize(s.owned, 0);
  if (c.stay.size() < s.owned) s.reorder(c.stay);
  if (c.births == 0) return;
  addSurfels(s, born, r.seed, all, region.taken ? &surface.surfels : nullptr);
  if (region.taken) std::copy(depth.begin(), depth.end(), s.depth.data() + s.owned - depth.size());
}

}  // namespace

void markForInspection(Surfels& s, const Bins& bins, const std::vector<std::uint8_t>& marked,
                       double spacing) {
  const double far = 3 * spacing;
  for (std::size_t i = 0; i < s.size(); i++) {
    if (!marked[i]) continue;
    const Vec3d x = s.position[i];
    forRowsAround(bins, x, x, far, [&](std::uint32_t j, const Vec3d&) {
      if (j >= s.owned) return;
      const Vec3d d = s.position[j] - x;
      const double reach = (s.resampleMargin[j] == refused ? 3 : 2) * s.radius[j];
      if (dot(d, d) < reach * reach) s.resampleMargin[j] = 0;
    });
  }
}

Resampled resample(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t, std::int64_t rounds,
                   const BirthPlace& mayBe) {
  Surface& surface = w.surface;
  Surfels& all = surface.surfels;
  const double reach = std::min(3 * surface.spacing, leastEdge(surface.grid));
  ActiveSet& region = t.activeSet;
  Resampled done;
  std::int64_t surfels = 0;
  all.resize(all.owned, 0);
  const bool adapt = w.scene.surface.adapt > 0;
  if (!adapt) relaxRadii(surface);
  for (std::int64_t round = 0; round < rounds && !done.finished && !done.capped; round++) {
    if (region.taken && !activeSetSuffices(region, halos.all)) returnActiveSet(surface, region);
    Surfels* table = region.taken ? &region.surfels : &all;
    const bool adapts = adapt && round == 0;
    excludeSmallDrops(surface, *table);
    if (!adapts && countOpen(*table, halos.all) == 0) {
      done.finished = true;
      break;
    }
    Round r{table,
            t.surfelsOf,
            reach,
            w.scene.seed,
            saltOf(w, done, round),
            mayBe,
            w.clock.step == 0,
            t.relax.surfelBins,
            w.scene.spacing,
            adapts,
            surfels};
    beginRound(w, halos, t, r);
    r.findCandidates();
    refreshGhosts(halos.surfels, *r.table, ColumnList{&r.table->resampleFlags, &r.table->candidateOffset});
    RoundChanges changes = selectChanges(r, halos.all);
    if (round == 0) surfels = changes.surfels;
    done.finished = changes.births + changes.deaths == 0;
    done.capped = limitBirths(r, birthCap(surfels) - done.births, changes, halos.all);
    if (changes.births + changes.deaths > 0) inspectAround(changes, surface.spacing, halos, r);
    done.births += changes.births;
    done.deaths += changes.deaths;
    applyChanges(surface, changes, region, r, halos.all);
  }
  returnActiveSet(surface, region);
  for (std::size_t i = 0; i < all.owned; i++) all.resampleMargin[i] = std::max(0.0f, all.resampleMargin[i]);
  surface.counters.births += done.births;
  surface.counters.deaths += done.deaths;
  surface.counters.capped += done.capped;
  placeRows(surface.grid, halos.surfels, all, surface.surfelCells, t.sort);
  return done;
}

}  // namespace thaw
