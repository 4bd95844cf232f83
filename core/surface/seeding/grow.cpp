// SPDX-License-Identifier: Apache-2.0
#include "core/surface/seeding/grow.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/hash_random.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/data/remove_surfels.hpp"
#include "core/surface/data/sampled_bodies.hpp"
#include "core/surface/data/surfel_ids.hpp"
#include "core/surface/field/iso_surface.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/measures/measure.hpp"
#include "core/surface/measures/small_drops.hpp"
#include "core/surface/relaxation/enforce_volume.hpp"
#include "core/surface/relaxation/relax.hpp"
#include "core/surface/relaxation/surfel_move.hpp"
#include "core/surface/relaxation/wall_projection.hpp"
#include "core/surface/resampling/birth_colours.hpp"
#include "core/surface/resampling/births.hpp"
#include "core/surface/resampling/resample.hpp"
#include "core/surface/seeding/drop_sphere.hpp"
#include "core/surface/seeding/narrow_gaps.hpp"
#include "core/surface/seeding/seeds.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

// Largest deviation of the colour from its level. It corresponds to more than one particle spacing.
constexpr double offSurface = 0.3;

// Smallest colour over its level for births on meshes. It corresponds to one particle spacing above the
// surface.
constexpr double leastOverDetail = 0.3;

// Smallest colour over its level for grown surfels. On drops, the level itself is below offSurface.
constexpr double leastOver = 0.25;

/// Returns whether a surfel belongs to a solid mesh, with detail finer than particles can resolve.
bool keepsDetail(const Surfels& f, std::size_t i) {
  return f.detail[i] > 0.5f && (!f.liquid.active || f.liquid[i] < 0.5f);
}

/// Appends surfels around one particle.
void seedAround(const SurfaceView& w, FieldProbe& probe, std::size_t i, SeedDirections& seeds,
                std::vector<SurfelRow>& rows) {
  std::array<Vec3d, FieldProbe::most> u;
  std::array<std::optional<SurfacePoint>, FieldProbe::most> at;
  seeds.turn(w.surface.particles.id[i]);
  for (int first = 0; first < seeds.count(); first += static_cast<int>(u.size())) {
    const auto n = std::min(u.size(), static_cast<std::size_t>(seeds.count() - first));
    for (std::size_t k = 0; k < n; k++) u[k] = seeds[first + static_cast<int>(k)];
    seedsOnSurface(probe, i, u.data(), n, at.data());
    for (std::size_t k = 0; k < n; k++)
      if (at[k]) rows.push_back(seedSurfel(w, i, first + static_cast<int>(k), *at[k]));
  }
}

/// Appends surfels around all owned particles selected by `exposed`.
void seedAll(const SurfaceView& w, const SurfaceTools& t, const std::function<bool(std::size_t)>& exposed,
             std::vector<SurfelRow>& rows) {
  const SurfaceParticles& p = w.surface.particles;
  SeedDirections seeds(w.scene, w.surface);
  FieldProbe probe(w.scene, w.surface, t);
  for (std::size_t i = 0; i < p.owned; i++)
    if (exposed(i) && p.component[i] != noComponent && p.colour[i] < innerColour)
      seedAround(w, probe, i, seeds, rows);
}

/// Appends the spherical surface of the small drop labelled by particle i. The drop's other particles are
/// within reach.
void sphereAround(const SurfaceView& w, const SurfaceTools& t, std::size_t i, std::vector<SurfelRow>& rows) {
  const SurfaceParticles& p = w.surface.particles;
  const double far = 4.5 * w.scene.spacing;
  Vec3d away;
  double volume = 0, temperature = 0, liquid = 0;
  forRowsAround(t.relax.particleBins, p.position[i], p.position[i], far, [&](std::uint32_t j, const Vec3d&) {
    const Vec3d d = p.position[j] - p.position[i];
    if (p.component[j] != p.component[i] || dot(d, d) > far * far) return;
    const double own = p.volumeRatio[j] * p.volume[j];
    volume += own;
    away += own * d;
    if (p.temperature.active) temperature += own * static_cast<double>(p.temperature[j]);
    if (p.liquid.active) liquid += own * static_cast<double>(p.liquid[j]);
  });
  for (SurfelRow& r : dropSphere(p.component[i], p.position[i] + away / volume, volume, w.surface.spacing)) {
    r.temperature = static_cast<float>(temperature / volume);
    r.liquid = static_cast<float>(liquid / volume);
    r.colour = surfaceColour(w.scene, p.body[i]);
    r.particle = static_cast<std::uint32_t>(i);
    // Surfels of a merging drop go to the larger body. A later drop may have the same label, so the step
    // number makes ids unique.
    r.id = surfelBit | birthBit |
           randomBits(w.scene.seed, Purpose::SurfelBirth, r.id, static_cast<std::uint64_t>(w.clock.step));
    rows.push_back(r);
  }
}

/// Returns whether the surface continues at p on a wall, and projects p onto the wall. There, the iso-surface
/// lies inside the wall, so the surface continues wherever the body lies above the wall.
bool continuesAtWall(const SurfaceView& w, FieldProbe& probe, const Surfels& f, std::size_t i,
                     SurfacePoint& p) {
  if (!f.wallOffset.active || liquidShare(f, i) < 0.5) return false;
  const Vec3d x = projectedOutOfWalls(w, p.position, p.normal);
  Vec3d into;
  if (!facesWall(w, x, p.normal, into)) return false;
  FieldSample c;
  probe.around({x, x}, f.component[i], f.position[i]);
  probe.at(&x, 1, &c);
  if (!(c.value > c.level)) return false;
  p = {x, into};
  return true;
}

/// Returns whether a surfel at p would float in front of its component's own surface. A sheet behind p then
/// faces p without a particle in between: above an edge, or where the colour bridges a groove. Births there
/// would continue as a skin over the groove.
bool floatsBeforeSheet(const SurfaceView& w, const SurfaceTools& t, const Surfels& f, std::size_t i,
                       const SurfacePoint& p) {
  constexpr double seen = 0.35, behind = 0.2, thick = 0.6;
  const double dx = w.scene.spacing, r = f.radius[i],
               reach = std::min(
                   2 * dx,
                   std::min({w.surface.grid.edge.x, w.surface.grid.edge.y, w.surface.grid.edge.z}) - r);
  const SurfaceParticles& q = w.surface.particles;
  // true if a particle lies between p and p + d
  const auto between = [&](const Vec3d& d) {
    const double far2 = dot(d, d);
    bool found = false;
    forRowsAround(t.relax.particleBins, p.position, p.position + d, thick * dx,
                  [&](std::uint32_t k, const Vec3d& at) {
                    const Vec3d c = at - p.position;
                    const double along = dot(c, d) / far2;
                    found = found || (q.component[k] == f.component[i] && along > 0 && along < 1 &&
                                      dot(c, c) - along * along * far2 < thick * thick * dx * dx);
                  });
    return found;
  };
  bool before = false;
  forRowsAround(t.relax.surfelBins, p.position, p.position, reach, [&](std::uint32_t j, const Vec3d& at) {
    if (before || j == i || f.component[j] != f.component[i]) return;
    const Vec3d d = at - p.position;
    const double far = length(d), front = -dot(f.normal[j], d);
    if (far < reach && front > 0.5 * r && front > seen * far && dot(p.normal, d) < -behind * far &&
        !between(d))
      before = true;
  });
  return before;
}

/// Marks the surfels around those with dead[row] == 2 for resampling. Requires: placed surfels.
void markAroundDeleted(Surface& s, CellHalo& halo, SurfaceTools& t, const std::vector<std::uint8_t>& dead) {
  Surfels& f = s.surfels;
  for (std::size_t i = 0; i < f.owned; i++) f.resampleFlags[i] = dead[i] == 2;
  addGhosts(halo, f, s.surfelCells, ColumnList{&f.id, &f.position, &f.resampleFlags});
  fillBins(s.grid, s.surfelCells, f.position.data(), 2 * s.spacing, t.relax.surfelBins);
  markForInspection(f, t.relax.surfelBins, {f.resampleFlags.data(), f.resampleFlags.data() + f.size()},
                    s.spacing);
  f.resize(f.owned, 0);
}

}  // namespace

void growSurfels(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t,
                 const std::function<bool(std::size_t)>& exposed) {
  prepareParticles(w.scene, w.surface, halos, t);
  std::vector<SurfelRow> rows;
  seedAll(w, t, exposed, rows);
  w.surface.surfels.resize(w.surface.surfels.owned, 0);
  addSurfels(w.surface.surfels, rows, w.scene.seed, halos.all);
}

void resampleOnParticles(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t, std::int64_t rounds) {
  prepareParticles(w.scene, w.surface, halos, t);
  listIsoOffsets(w.scene, w.surface, t.relax.isoOffset);
  FieldProbe probe(w.scene, w.surface, t);
  resample(w, halos, t, rounds, [&](const Surfels& f, std::size_t i, SurfacePoint& p, bool border) {
    // Births continue the mesh's surface, but do not bridge a crack.
    if (!border && keepsDetail(f, i)) {
      FieldSample c;
      probe.around({p.position, p.position}, f.component[i], f.position[i]);
      probe.at(&p.position, 1, &c);
      return c.value > leastOverDetail * c.level;
    }
    if (border && f.hasReference.active && f.hasReference[i])
      // The initial surface has no border. Beyond a crease, births would continue as a skin over the groove.
      return false;
    if (continuesAtWall(w, probe, f, i, p)) return true;
    if (border && liquidShare(f, i) < 0.5 && floatsBeforeSheet(w, t, f, i, p)) return false;
    std::optional<SurfacePoint> at;
    const auto onto = [&](const Vec3d& x) {
      projectToIsoSurface(probe, {f.component[i], f.position[i], 0.6 * f.radius[i] + 0.1 * w.scene.spacing},
                          {&x, 1}, &at);
      return at && dot(at->normal, p.normal) >= 0.3;
    };
    // Offset surfaces continue at the same offset. Half-solid surfels remain where they were carried.
    if (!onto(p.position)) {
      const double isoOffset = f.liquid.active && f.liquid[i] > 0.9f
                                   ? isoOffsetOf(t.relax.isoOffset, f.component[i])
                                   : 0;
      if (isoOffset == 0 || !onto(p.position - isoOffset * p.normal)) return false;
    }
    p.normal = normalized(p.normal + at->normal);
    return true;
  });
}

namespace {

/// Grows the surfaces of the particles selected by `exposed` and relaxes them.
void growAndRelax(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t,
                  const std::function<bool(std::size_t)>& exposed) {
  growSurfels(w, halos, t, exposed);
  std::int64_t grown = static_cast<std::int64_t>(w.surface.surfels.owned);
  halos.all.sum({&grown, 1});
  if (grown == 0) return;
  const SurfaceCounters before = w.surface.counters;
  resampleOnParticles(w, halos, t, 40);
  ForceWeights tight;
  relaxSurfels(w, halos, t, tight, 5, true);
  resampleOnParticles(w, halos, t, 10);
  for (int k = 0; k < 2; k++) {
    relaxSurfels(w, halos, t, forceWeights(w.scene.surface), w.scene.surface.iterations, true);
    resampleOnParticles(w, halos, t, 10);
  }
  // The initial surface does not count as a change.
  w.surface.counters = before;
}

}  // namespace

// Gaps between liquid sheets may close. For solids, the colour field with the surface's support may merge two
// sheets, such as layers of particles two spacings apart. The field with the particles' own support separates
// them.
void growBodies(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  const double wide = s.particleSupport,
               narrow = std::min({wide, w.grid.support, nearSupport * w.scene.spacing});
  prepareParticles(w.scene, w.surface, halos, t);
  const NarrowGaps gaps = narrow < wide ? findNarrowGaps(w.scene, w.surface, t.relax.particleBins, halos.all)
                                        : NarrowGaps{};
  const std::vector<std::uint64_t>& near = gaps.solid;
  t.mergedSheets = gaps.liquid;
  const auto exposed = [&](std::size_t i, bool isNear) {
    return !isSampled(w.scene, s.particles.body[i]) &&
           std::binary_search(near.begin(), near.end(), s.particles.component[i]) == isNear;
  };
  growAndRelax(w, halos, t, [&](std::size_t i) { return exposed(i, false); });
  if (near.empty()) return;
  t.relax.only = near;
  s.particleSupport = narrow;
  t.relax.particlesPrepared = false;
  growAndRelax(w, halos, t, [&](std::size_t i) { return exposed(i, true); });
  s.particleSupport = wide;
  t.relax.particlesPrepared = false;
  t.relax.only.clear();
}

void renewSurfels(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  prepareParticles(w.scene, w.surface, halos, t);
  const SurfaceParticles& p = s.particles;
  SmallDrops small(s);
  std::vector<std::uint8_t> dead(f.owned, 0);
  std::int64_t gone = 0;
  std::vector<std::uint8_t> probed(f.owned, 0);
  for (std::size_t i = 0; i < f.owned; i++) {
    // Spheres of small drops are rebuilt below.
    if (small(f.component[i])) dead[i] = 1;
    else probed[i] = !keepsDetail(f, i) && !(f.hasReference.active && f.hasReference[i]);
  }
  forFieldAtSurfels(w.scene, w.surface, t, probed, [&](std::size_t i, const FieldSample& c) {
    if (std::abs(c.value - c.level) <= offSurface && c.value >= leastOver * c.level) return;
    if (Vec3d into;
        f.wallOffset.active && c.value > c.level && facesWall(w, f.position[i], f.normal[i], into))
      return;
    dead[i] = 2, gone++;
  });
  halos.all.sum({&gone, 1});
  if (gone > 0) markAroundDeleted(s, halos.surfels, t, dead);
  std::vector<SurfelRow> rows;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.component[i] == 1 + p.id[i] && small(p.component[i])) sphereAround(w, t, i, rows);
  seedAll(
      w, t,
      [&](std::size_t i) {
        const SurfaceComponent* c = findComponent(s, p.component[i]);
        return c && c->surfels == 0 && c->particles > smallDrop;
      },
      rows);
  // Surfels about to be deleted also pass on their colours, so drops keep their colours.
  inheritColours(w.scene, w.surface, halos, t, rows);
  removeSurfels(s, dead);
  addSurfels(f, rows, w.scene.seed, halos.all);
  s.counters.deaths += gone;
}

}  // namespace thaw
