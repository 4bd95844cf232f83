// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/relax.hpp"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <numbers>

#include "core/surface/data/place_rows.hpp"
#include "core/surface/field/field_probe.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/relaxation/active_surfels.hpp"
#include "core/surface/relaxation/project_distant.hpp"
#include "core/surface/relaxation/surfel_move.hpp"
#include "core/surface/relaxation/wall_projection.hpp"
#include "core/surface/search/near_sheets.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

/// Processor time since the last call.
class Lap {
 public:
  void operator()(double& to) {
    const std::clock_t now = std::clock();
    to += static_cast<double>(now - last_) / CLOCKS_PER_SEC;
    last_ = now;
  }

 private:
  std::clock_t last_ = std::clock();
};

void packSurfel(const Surface& s, RelaxTools& r, std::size_t i) {
  const Surfels& f = s.surfels;
  float *place = &r.place[4 * i], *normal = &r.normal[4 * i];
  for (int a = 0; a < 3; a++) {
    const std::uint32_t bits = fixedPoint(s.grid, f.position[i][a], a);
    std::memcpy(place + a, &bits, 4);
    normal[a] = static_cast<float>(f.normal[i][a]);
  }
  // Surfels stopped at the margin do not activate others.
  place[3] = f.moving[i] == 1 ? 1.0f : 0.0f;
  normal[3] = static_cast<float>(std::min(f.radius[i], s.spacing) / s.grid.support);
}

/// Largest relevant gap over h_ps. It is below 1, because a sheet's particles lie half a spacing behind its
/// surface.
constexpr double gapReach = 0.75;

/// Number of iterations before moves normal to the surface are damped, and damping factor of each later
/// iteration.
constexpr std::int64_t easeAfter = 8;
constexpr double easing = 0.8;

void markMovable(const Surface& s, bool all, RelaxTools& r) {
  markFree(s, all, r.free);
  for (std::size_t i = 0; i < r.free.size() && !r.only.empty(); i++)
    r.free[i] = r.free[i] && std::binary_search(r.only.begin(), r.only.end(), s.surfels.component[i]);
}

/// Migrates and sorts surfels, adds ghosts, and rebuilds all lists. Collective.
void search(Surface& s, SurfaceHalos halos, SurfaceTools& t, bool all, bool first, double margin, Lap& lap) {
  Surfels& f = s.surfels;
  RelaxTools& r = t.relax;
  placeRows(s.grid, halos.surfels, f, s.surfelCells, t.sort);
  ColumnList columns{&f.id, &f.position, &f.normal, &f.radius, &f.component, &f.moving, &f.resampleFlags};
  addGhosts(halos.surfels, f, s.surfelCells, columns);
  lap(r.times.place);
  const ListRadii radii{s.surfelSupport + margin, s.particleSupport + 0.5 * margin};
  fillBins(s.grid, s.surfelCells, f.position.data(), radii.surfels, r.surfelBins);
  markMovable(s, all, r);
  r.core.assign(r.free.begin(), r.free.end());
  if (!first) markActive(s, halos.surfels, r.surfelBins, s.surfelSupport + margin, r.free, r.core);
  listGroups(s, r.free, r.surfelBins, r.particleBins, radii, r.lists);
  const double gap = gapReach * s.particleSupport;
  // All pairs of bins within a gap are tested.
  if (first) fillBins(s.grid, s.surfelCells, f.position.data(), gap / 3, r.gapBins);
  findGapCutoffs(s, r.free, first ? r.gapBins : r.surfelBins, gap, !first);
  packGapCutoffs(s, r.lists, r.gapCutoffs);
  r.found.assign(f.position.data(), f.position.data() + f.owned);
  r.place.resize(4 * f.size());
  r.normal.resize(4 * f.size());
  for (std::size_t i = 0; i < f.size(); i++) packSurfel(s, r, i);
  lap(r.times.search);
  r.times.searches++;
}

ForceSums sumsOf(const Scene& scene, const Surface& surface, SurfaceTools& t) {
  RelaxTools& r = t.relax;
  ForceSums in = particleSumsOf(scene, surface, t);
  in.plane = scene.surface.smoothing == SmoothingForm::Plane;
  r.overSurfels.resize(r.lists.groups() * 8 * (in.plane ? planeSums : sphereSums));
  r.overParticles.resize(r.lists.groups() * 8 * particleSums);
  in.place = r.place.data();
  in.normal = r.normal.data();
  in.self = r.lists.self.data();
  in.firstSurfel = r.lists.firstSurfel.data();
  in.firstParticle = r.lists.firstParticle.data();
  in.surfel = r.lists.surfel.data();
  in.particleRow = r.lists.particle.data();
  in.support = static_cast<float>(scene.surface.support);
  in.repelRange = 1.5f;
  in.sameSide = std::numbers::sqrt2_v<float> / 2;
  in.perSide = 10;
  in.apart = static_cast<float>(twoSheets);
  if (r.gapCutoffs.any)
    in.gapCutoff = r.gapCutoffs.height.data(), in.groupHasGapCutoff = r.gapCutoffs.ofGroup.data();
  in.overSurfels = r.overSurfels.data();
  in.overParticles = r.overParticles.data();
  return in;
}

/// Lists groups with a moving surfel in their list.
void listMovingGroups(const GroupLists& l, const Surfels& f, std::vector<std::uint32_t>& groups) {
  groups.clear();
  for (std::uint32_t g = 0; g < l.groups(); g++)
    for (std::uint64_t k = l.firstSurfel[g]; k < l.firstSurfel[g + 1]; k++)
      if (f.moving[l.surfel[k]]) {
        groups.push_back(g);
        break;
      }
}

/// Keeps groups with a moving surfel, or with a surfel that has a moving surfel within h_ss.
void keepMovingGroups(const GroupLists& l, const float* sums, int channels,
                      std::vector<std::uint32_t>& groups) {
  std::erase_if(groups, [&](std::uint32_t g) {
    const float* movedNearby = sums + (static_cast<std::size_t>(g) * static_cast<std::size_t>(channels) +
                                       MovedNearby) *
                                          8;
    return std::none_of(movedNearby, movedNearby + l.lanes[g], [](float x) { return x > 0; });
  });
}

/// Returns the sums of a group and lane.
SurfelSums sumsAt(const ForceSums& in, std::uint32_t g, int lane) {
  const std::size_t channels = in.plane ? planeSums : sphereSums;
  return {in.overSurfels + static_cast<std::size_t>(g) * 8 * channels,
          in.overParticles + static_cast<std::size_t>(g) * 8 * particleSums, lane};
}

/// Activates the columns of relaxation. Free surfels move.
void beginRelaxation(const SurfaceView& w, const std::vector<std::uint8_t>& free) {
  Surfels& f = w.surface.surfels;
  f.activate(f.moving);
  f.activate(f.stepShare);
  f.activate(f.gapCutoff);
  for (std::size_t i = 0; i < f.owned; i++) f.moving[i] = free[i], f.stepShare[i] = 0;
  alignWithWalls(w, free);
}

/// Removes ghosts and columns of relaxation, and adds up the counters. Collective.
void endRelaxation(Surface& s, const MoveCounts& counts, Reducer& all) {
  Surfels& f = s.surfels;
  std::int64_t total[2]{counts.flipped, counts.keptNormals};
  all.sum(total);
  s.counters.flipped += total[0];
  s.counters.keptNormals += total[1];
  f.resize(f.owned, 0);
  deactivate(f.moving);
  deactivate(f.stepShare);
  deactivate(f.gapCutoff);
  deactivate(f.wallAligned);
}

/// Computes the sums over surfels and particles for the groups with work. Lists these groups in
/// RelaxTools::groups.
ForceSums sumForces(const SurfaceView& w, SurfaceTools& t, Lap& lap) {
  RelaxTools& r = t.relax;
  ForceSums in = sumsOf(w.scene, w.surface, t);
  const int channels = in.plane ? planeSums : sphereSums;
  listMovingGroups(r.lists, w.surface.surfels, r.groups);
  in.groups = r.groups.data();
  in.groupCount = r.groups.size();
  r.kernels->overSurfels(in);
  lap(r.times.surfelSums);
  keepMovingGroups(r.lists, in.overSurfels, channels, r.groups);
  in.groupCount = r.groups.size();
  r.kernels->overParticles(in);
  lap(r.times.particleSums);
  return in;
}

/// Motion of surfels after an iteration, on this rank or on all.
struct Motion {
  bool running = true;   ///< a surfel moves
  bool spreads = false;  ///< a surfel outside of the core moves
  bool stopped = false;  ///< a surfel stopped at its margin
};

/// Moves the surfels of all groups with work.
Motion moveSurfels(const SurfaceView& w, RelaxTools& r, const MoveContext& context, const ForceSums& in,
                   MoveCounts& counts) {
  Surfels& f = w.surface.surfels;
  Motion motion{false, false, false};
  // Surfels of groups without work did not move in the last iteration.
  for (const std::uint32_t g : r.groups) {
    const double isoOffset = isoOffsetOf(r.isoOffset, f.component[r.lists.self[8 * g]]);
    for (int lane = 0; lane < r.lists.lanes[g]; lane++) {
      const SurfelSums sums = sumsAt(in, g, lane);
      if (!(sums.surfel(MovedNearby) > 0)) continue;
      const std::size_t i = r.lists.self[8 * g + static_cast<std::size_t>(lane)];
      moveSurfel(w, context, sums, isoOffset, i, counts);
      if (f.moving[i] == 1) {
        motion.running = true;
        if (!r.core[i]) motion.spreads = true;
      }
      packSurfel(w.surface, r, i);
      r.times.surfels++;
    }
  }
  motion.stopped = std::find(f.moving.data(), f.moving.data() + f.owned, stoppedAtMargin) !=
                   f.moving.data() + f.owned;
  return motion;
}

/// Refreshes ghosts. Returns the motion on all ranks. Collective.
Motion exchangeMotion(Surface& s, SurfaceHalos halos, RelaxTools& r, const Motion& own) {
  Surfels& f = s.surfels;
  ColumnList columns{&f.position, &f.normal, &f.moving};
  refreshGhosts(halos.surfels, f, columns);
  for (std::size_t i = f.owned; i < f.size(); i++) packSurfel(s, r, i);
  double any[3]{own.running ? 1.0 : 0.0, own.spreads ? 1.0 : 0.0, own.stopped ? 1.0 : 0.0};
  halos.all.maximum(any);
  return {any[0] > 0, any[1] > 0, any[2] > 0};
}

/// Damping of moves. Normal to the surface, most surfels stop after a few iterations. Along the surface, long
/// waves of density would keep them in motion, which K05's damping prevents. At the rims of a splash, surfels
/// would also keep moving normal to the surface. Their motion after easeAfter continues in the next update.
struct Damping {
  double along = 1, across = 1;
  void advance(std::int64_t iteration) {
    along *= 0.95;
    if (iteration >= easeAfter) across *= easing;
  }
};

}  // namespace

RelaxationResult relaxSurfels(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t,
                              const ForceWeights& weights, std::int64_t iterations, bool all) {
  Surfels& f = w.surface.surfels;
  RelaxTools& r = t.relax;
  Lap lap;
  prepareParticles(w.scene, w.surface, halos, t);
  lap(r.times.ready);
  f.resize(f.owned, 0);
  markMovable(w.surface, all, r);
  std::int64_t free[1] = {std::count(r.free.begin(), r.free.end(), 1)};
  halos.all.sum(free);
  if (free[0] == 0) return {0, true};
  // In an update, blendSurfels reads the motion.
  if (all) std::fill_n(f.resampleMargin.data(), f.owned, 0.0f);
  beginRelaxation(w, r.free);
  // Lists are valid until a surfel has moved by half the margin. The grid's cells allow motion of half a
  // particle spacing.
  const double margin = listMargin(w.surface, w.scene.spacing);
  search(w.surface, halos, t, all, true, margin, lap);
  RelaxationResult done;
  MoveCounts counts;
  Damping damping;
  Motion motion;
  std::int64_t nextSearch = 1;
  while (done.iterations < iterations && !done.finished) {
    // A surfel that stopped at its margin continues after the next search. Searches become less frequent,
    // since few such surfels remain.
    if (motion.spreads || (motion.stopped && (!motion.running || done.iterations >= nextSearch))) {
      if (done.iterations == 1)
        // Only once: forces may move surfels off the iso-surface again.
        projectDistantSurfels(w, halos, t);
      std::replace(f.moving.data(), f.moving.data() + f.owned, stoppedAtMargin, std::uint8_t{1});
      search(w.surface, halos, t, all, false, margin, lap);
      nextSearch = done.iterations + 2 + done.iterations / 2;
    }
    const ForceSums in = sumForces(w, t, lap);
    MoveContext context = moveContext(w.scene, w.surface, r, weights);
    context.spread = damping.along;
    context.ease = damping.across;
    context.stray = 0.5 * margin;
    context.found = r.found.data();
    damping.advance(done.iterations);
    const Motion own = moveSurfels(w, r, context, in, counts);
    lap(r.times.finish);
    motion = exchangeMotion(w.surface, halos, r, own);
    done.finished = !motion.stopped && !motion.running;
    done.iterations++;
    lap(r.times.exchange);
  }
  endRelaxation(w.surface, counts, halos.all);
  return done;
}

}  // namespace thaw
