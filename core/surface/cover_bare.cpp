#include "core/surface/cover_bare.hpp"

#include <algorithm>
#include <cmath>

#include "core/surface/births.hpp"
#include "core/surface/drop_surfels.hpp"
#include "core/surface/grow.hpp"
#include "core/surface/iso_surface.hpp"
#include "core/surface/local_surface.hpp"
#include "core/surface/place_rows.hpp"
#include "core/surface/point_bins.hpp"
#include "core/surface/ready_particles.hpp"
#include "core/surface/seeds.hpp"
#include "core/surface/small_drops.hpp"
#include "core/surface/update_surface.hpp"

namespace thaw {
namespace {

/// A direction is taken by a particle within this many spacings ...
constexpr double neighbourReach = 1.7;
/// ... that lies less than 41 degrees off it.
constexpr double taken = 0.75;
/// Surfels are looked for within this many spacings of a particle or seed. A mesh may lie a spacing over the outermost particles.
constexpr double surfelReach = 1.8;
/// Over a true opening the colour falls below this share of its level half a spacing farther out.
constexpr double fallsTo = 0.75;
/// How far the colour at a grown surfel may be from its level, over that: a third of a spacing outward, half a spacing inward. A mesh's: .8 outward.
constexpr double hangsOver = 0.2, liesUnder = 0.4, meshOver = 0.5;
/// A mesh's surfels are looked at where grown ones are within this many spacings.
constexpr double ragReach = 3.5;
/// Surfels within this many spacings of new ones settle with them.
constexpr double looseReach = 2.5;
constexpr int mostRounds = 3;

/// Is a disc of the surface above or below a place with this normal?
bool covered(const Surfels& f, const std::vector<std::uint32_t>& near, const Vec3d& x, const Vec3d& normal, double most) {
  for (const std::uint32_t j : near) {
    const Vec3d d = f.position[j] - x;
    const double facing = dot(f.normal[j], normal), along = dot(d, normal), off2 = dot(d, d), across2 = off2 - along * along;
    if (facing > 0.2 && std::abs(along) < most && across2 < f.radius[j] * f.radius[j]) return true;
    if (facing > oneSide && off2 < 0.8 * f.radius[j] * f.radius[j]) return true;
  }
  return false;
}

/// Surfels around owned particles, in rows. Surfels have ghosts and bins.
void seedBare(const World& w, const SurfaceTools& t, std::vector<SurfelRow>& rows) {
  const Surface& s = w.surface;
  const Surfels& f = s.surfels;
  const SurfaceParticles& p = s.particles;
  const double dx = w.scene.spacing, reach = surfelReach * dx, near2 = neighbourReach * neighbourReach * dx * dx;
  const int seeds = seedsOf(w);
  std::vector<Vec3d> beside;
  std::vector<std::uint32_t> over;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.component[i] == noComponent || p.colour[i] >= innerColour) continue;
    const SurfaceComponent* c = findComponent(s, p.component[i]);
    if (!c || c->particles <= smallDrop) continue;
    const Vec3d x = p.position[i];
    beside.clear();
    over.clear();
    forRowsAround(t.relax.particleBins, x, x, neighbourReach * dx, [&](std::uint32_t j, const Vec3d& at) {
      const Vec3d d = at - x;
      const double r2 = dot(d, d);
      if (p.component[j] == p.component[i] && r2 > 0 && r2 < near2) beside.push_back(d / std::sqrt(r2));
    });
    forRowsAround(t.relax.surfelBins, x, x, 2 * reach, [&](std::uint32_t j, const Vec3d& at) {
      if (f.component[j] == p.component[i] && dot(at - x, at - x) < 4 * reach * reach) over.push_back(j);
    });
    for (int k = 0; k < seeds; k++) {
      const Vec3d u = seedDirection(w, p.id[i], k, seeds);
      if (std::any_of(beside.begin(), beside.end(), [&](const Vec3d& d) { return dot(d, u) > taken; }) || covered(f, over, x + u * (0.5 * dx), u, reach)) continue;
      SurfacePoint at;
      if (!seedOnSurface(w, t, i, u, at) || covered(f, over, at.position, at.normal, reach)) continue;
      if (colourAt(w, t, p.component[i], at.position + at.normal * (0.5 * dx)).value > fallsTo * colourAt(w, t, p.component[i], at.position).level) continue;
      rows.push_back(seedSurfel(w, i, k, at));
    }
  }
}

/// Surfels of solids that are not on the surface any more: rags that hang off the rim of a crack, or were in the middle of one while it opened.
/// Of a mesh's, only those beside a face that was grown. Surfels have ghosts.
void findRags(const World& w, const SurfaceTools& t, std::vector<std::uint8_t>& dead) {
  const Surfels& f = w.surface.surfels;
  const double reach = ragReach * w.scene.spacing;
  const auto solid = [&](std::size_t i) { return !f.liquid.active || f.liquid[i] < 0.5f; };
  std::vector<Vec3d> grown;
  std::vector<std::uint64_t> component;
  for (std::size_t i = 0; i < f.size(); i++)
    if (f.detail[i] < 0.5f && solid(i)) grown.push_back(f.position[i]), component.push_back(f.component[i]);
  PointBins bins;
  bins.build(grown.data(), grown.size(), reach);
  dead.assign(f.owned, 0);
  for (std::size_t i = 0; i < f.owned && !grown.empty(); i++) {
    if (!solid(i)) continue;
    const bool detail = f.detail[i] >= 0.5f;  // of a mesh: finer than the particles, up to a spacing off their surface
    bool beside = !detail;
    if (detail) bins.forEachWithin(f.position[i], reach, [&](std::uint32_t j, double) { beside = beside || component[j] == f.component[i]; });
    if (!beside) continue;
    const FieldHere c = colourAt(w, t, f.component[i], f.position[i]);
    const double slope = length(c.gradient), along = slope > 0 ? -dot(c.gradient, f.normal[i]) / slope : -1;
    const double under = c.value / c.level - 1;
    dead[i] = detail ? under < -meshOver || along < -0.2 : under < -hangsOver || under > liesUnder || along < 0.5;
  }
}

/// Grown surfels of solids near loose ones settle with them: a crack that opens moves the surface beside what is born. Surfels have ghosts.
void loosenAround(const World& w, Surfels& f) {
  const double reach = looseReach * w.scene.spacing;
  std::vector<Vec3d> loose;
  std::vector<std::uint64_t> component;
  for (std::size_t i = 0; i < f.size(); i++)
    if (f.loose[i]) loose.push_back(f.position[i]), component.push_back(f.component[i]);
  PointBins bins;
  bins.build(loose.data(), loose.size(), reach);
  for (std::size_t i = 0; i < f.owned && !loose.empty(); i++) {
    if (f.loose[i] || f.detail[i] >= 0.5f) continue;
    bins.forEachWithin(f.position[i], reach, [&](std::uint32_t j, double) { f.loose[i] |= component[j] == f.component[i]; });
  }
}

}  // namespace

std::int64_t coverBare(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  readyParticles(w, halos, t);
  const auto look = [&] {
    placeRows(s.grid, halos.surfels, f, s.surfelCells, t.sort);
    ColumnList columns{&f.id, &f.position, &f.normal, &f.radius, &f.component, &f.detail};
    if (f.liquid.active) columns.push_back(&f.liquid);
    if (f.loose.active) columns.push_back(&f.loose);
    addGhosts(halos.surfels, f, s.surfelCells, columns);
    fillBins(s.grid, s.surfelCells, f.position.data(), surfelReach * w.scene.spacing, t.relax.surfelBins);
  };
  std::int64_t all = 0;
  for (int round = 0; round < mostRounds; round++) {
    look();
    std::vector<std::uint8_t> dead;
    findRags(w, t, dead);
    std::int64_t count[2] = {0, std::count(dead.begin(), dead.end(), 1)};
    halos.all.sum({count + 1, 1});
    if (count[1] > 0) {
      dropSurfels(s, dead);
      look();
    }
    std::vector<SurfelRow> rows;
    seedBare(w, t, rows);
    count[0] = static_cast<std::int64_t>(rows.size());
    halos.all.sum({count, 1});
    f.resize(f.owned, 0);
    if (count[0] > 0) {
      f.activate(f.loose);
      addSurfels(f, rows, w.scene.seed, halos.all);
    }
    s.counters.births += count[0];
    s.counters.deaths += count[1];
    all += count[0];
    if (count[0] == 0) break;
  }
  if (all > 0) {
    look();
    loosenAround(w, f);
    f.resize(f.owned, 0);
  }
  return all;
}

}  // namespace thaw
