// SPDX-License-Identifier: Apache-2.0
#include "core/surface/seeding/resurface_exposed.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/surface/advection/reference_motion.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/data/remove_surfels.hpp"
#include "core/surface/data/surfel_ids.hpp"
#include "core/surface/field/iso_surface.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/measures/small_drops.hpp"
#include "core/surface/resampling/birth_colours.hpp"
#include "core/surface/resampling/births.hpp"
#include "core/surface/search/bins.hpp"
#include "core/surface/search/local_surface.hpp"
#include "core/surface/seeding/disc_cover.hpp"
#include "core/surface/seeding/grow.hpp"
#include "core/surface/seeding/seeds.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

/// A particle within this many spacings blocks a seed direction (FreeDirections).
constexpr double neighbourReach = 1.7;
/// Search radius for surfels around a particle or seed, in spacings. A mesh may lie a spacing above the
/// outermost particles.
constexpr double surfelReach = 1.8;
/// At a true opening, the colour half a spacing farther out is below this fraction of its level.
constexpr double openingDrop = 0.75;
/// Largest deviation of the colour from its level at a grown surfel, over the level: a third of a spacing
/// outward, half a spacing inward. Surfels of a mesh may lie 0.8 spacings outward.
constexpr double mostOutward = 0.2, mostInward = 0.4, mostMeshOutward = 0.5;
/// A spur is a mesh surfel at the edge of a grown crack face. Its height above the nearest surfel of the face
/// within spurReach exceeds spurHeight spacings, although the two surfaces meet at a convex edge. Only fully
/// solid surfels count, because the detail of a melting mesh fades unevenly.
constexpr double spurHeight = 0.2, spurReach = 1.5, spurTurn = 0.7;
/// Grown surfels within this many spacings of new ones relax with them.
constexpr double relaxingReach = 2.5;
constexpr int mostRounds = 3;
/// Liquid of the same component within this many spacings is adjacent to a solid particle.
constexpr double liquidReach = 2;
/// A surfel with a reference position within this many spacings covers a particle.
constexpr double coverReach = 1.2;

/// Marks solid particles next to liquid as not covered. Their surface may become part of the liquid's
/// surface, and they are exposed when the liquid drains. A cold particle below surfels that follow their
/// reference stays covered. Requires: surfels with ghosts and bins.
void uncoverBesideLiquid(const Scene& scene, const SurfaceTools& t, Surface& s) {
  const Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  if (!p.covered.active || !p.liquid.active) return;
  constexpr float flowingFraction = 0.02f;
  std::vector<std::uint8_t> flows(p.size());
  for (std::size_t i = 0; i < p.size(); i++) flows[i] = p.liquid[i] >= flowingFraction;
  if (std::find(flows.begin(), flows.end(), 1) == flows.end()) return;
  Bins liquid;
  pickRows(t.relax.particleBins, flows.data(), liquid);
  for (std::uint32_t i = 0; i < p.owned; i++) {
    if (!p.covered[i]) continue;
    bool beside = flows[i];
    if (!beside)
      forRowsWithin(liquid, p.position[i], liquidReach * scene.spacing,
                    [&](std::uint32_t j, double) { beside = beside || p.component[j] == p.component[i]; });
    if (!beside) continue;
    bool kept = false;
    if (!flows[i])
      forRowsWithin(t.relax.surfelBins, p.position[i], coverReach * scene.spacing,
                    [&](std::uint32_t j, double) {
                      kept = kept || (f.component[j] == p.component[i] && hasReference(f, j));
                    });
    p.covered[i] = kept;
  }
}

/// Seeds surfels around exposed owned particles. Particles that the initial surface still covers are skipped.
/// On bent or compressed solids, the initial surface deviates from the colour's iso-surface, and seeds would
/// form a second skin. Requires: surfels with ghosts and bins.
class ExposedSeeder {
 public:
  ExposedSeeder(const SurfaceView& view, const SurfaceTools& tools, std::vector<SurfelRow>& rows)
      : view_(view),
        particles_(view.surface.particles),
        surfels_(view.surface.surfels),
        particleBins_(tools.relax.particleBins),
        surfelBins_(tools.relax.surfelBins),
        rows_(rows),
        spacing_(view.scene.spacing),
        seeds_(view.scene, view.surface),
        near_(spacing_, surfelReach),
        all_(spacing_, surfelReach),
        probe_(view.scene, view.surface, tools) {
    double largest = 0;
    for (std::size_t i = 0; i < surfels_.size(); i++) largest = std::max(largest, surfels_.radius[i]);
    // covers seeds up to 1.2 spacings from their particle
    far_ = 1.2 * spacing_ + std::hypot(surfelReach * spacing_, largest);
  }

  /// Appends seeds around the particles of a bin to the rows.
  void seedBin(std::size_t bin) {
    std::uint32_t seedable = 0;
    PlaceBox box{};
    const Bins& bins = particleBins_;
    for (std::uint32_t k = bins.first[bin]; k < bins.first[bin + 1]; k++)
      if (mayBeSeeded(bins.row[k])) {
        if (seedable++ == 0) box = {bins.at[k], bins.at[k]};
        box.add(bins.at[k]);
      }
    if (seedable == 0) return;
    block_.find(surfelBins_, box, spacing_);
    for (std::uint32_t k = bins.first[bin]; k < bins.first[bin + 1]; k++)
      if (mayBeSeeded(bins.row[k])) seedAround(bins.row[k]);
  }

 private:
  bool mayBeSeeded(std::uint32_t i) const {
    const SurfaceParticles& p = particles_;
    if (i >= p.owned || p.component[i] == noComponent || p.colour[i] >= innerColour ||
        (p.covered.active && p.covered[i]))
      return false;
    const SurfaceComponent* c = findComponent(view_.surface, p.component[i]);
    return c && c->particles > smallDrop;
  }

  /// Sets the directions from particle i without particles nearby, and the cover of the nearest surfels.
  void findFree(std::uint32_t i) {
    const SurfaceParticles& p = particles_;
    const Surfels& f = surfels_;
    const Vec3d x = p.position[i];
    const double near = neighbourReach * spacing_,
                 near2 = neighbourReach * neighbourReach * spacing_ * spacing_;
    seeds_.turn(p.id[i]);
    free_.begin(seeds_);
    forRowsAround(particleBins_, x, x, near, [&](std::uint32_t j, const Vec3d& at) {
      const Vec3d d = at - x;
      const double r2 = dot(d, d);
      if (p.component[j] == p.component[i] && r2 > 0 && r2 < near2) free_.take(d / std::sqrt(r2));
    });
    near_.clear();
    for (const std::uint32_t k : block_.around(x, spacing_)) {
      const std::uint32_t j = block_.row[k];
      const Vec3d d = block_.at[k] - x;
      if (dot(d, d) < spacing_ * spacing_ && f.component[j] == p.component[i])
        near_.add(d, f.normal[j], f.radius[j]);
    }
  }

  /// Sets the cover of all surfels that may reach a seed of particle i.
  void coverAll(std::uint32_t i) {
    const Vec3d x = particles_.position[i];
    all_.clear();
    forRowsAround(surfelBins_, x, x, far_, [&](std::uint32_t j, const Vec3d& at) {
      if (surfels_.component[j] == particles_.component[i])
        all_.add(at - x, surfels_.normal[j], surfels_.radius[j]);
    });
  }

  void seedAround(std::uint32_t i) {
    findFree(i);
    bool covered = false;
    count_ = 0;
    for (int k = 0; k < seeds_.count(); k++) {
      const Vec3d u = seeds_[k];
      // Surfels near the particle already cover most directions.
      if (free_.taken(k) || near_.covers(u)) continue;
      if (!covered) coverAll(i);
      covered = true;
      if (all_.covers(u)) continue;
      direction_[count_] = u, number_[count_] = k;
      if (++count_ == direction_.size()) addSeeds(i);
    }
    if (count_ > 0) addSeeds(i);
  }

  /// Appends the seeds of the collected directions that lie at an opening, and begins a new collection.
  void addSeeds(std::uint32_t i) {
    const Vec3d x = particles_.position[i];
    seedsOnSurface(probe_, i, direction_.data(), count_, at_.data());
    for (std::size_t k = 0; k < count_; k++) {
      const std::optional<SurfacePoint>& at = at_[k];
      if (!at || all_.covers(at->position - x, at->normal)) continue;
      const std::array<Vec3d, 2> places{at->position, at->position + at->normal * (0.5 * spacing_)};
      std::array<FieldSample, 2> field;
      PlaceBox box{places[0], places[0]};
      box.add(places[1]);
      probe_.around(box, particles_.component[i], x);
      probe_.at(places.data(), 2, field.data());
      if (field[1].value <= openingDrop * field[0].level)
        rows_.push_back(seedSurfel(view_, i, number_[k], *at));
    }
    count_ = 0;
  }

  const SurfaceView& view_;
  const SurfaceParticles& particles_;
  const Surfels& surfels_;
  const Bins &particleBins_, &surfelBins_;
  std::vector<SurfelRow>& rows_;
  double spacing_, far_;  // m; far_: radius of coverAll
  SeedDirections seeds_;
  FreeDirections free_;
  DiscCover near_, all_;
  RowBlock block_;  // surfels around the particles of the bin
  FieldProbe probe_;
  std::size_t count_ = 0;  // collected directions
  std::array<Vec3d, FieldProbe::most> direction_;
  std::array<int, FieldProbe::most> number_;
  std::array<std::optional<SurfacePoint>, FieldProbe::most> at_;
};

/// Marks surfels of solids that are no longer on the surface: beyond the edge of a crack, or inside a
/// crack that opened. Mesh surfels are tested only near grown faces. Requires: surfels with ghosts.
void findDetached(const Scene& scene, const Surface& surface, SurfaceTools& t,
                  std::vector<std::uint8_t>& dead) {
  const Surfels& f = surface.surfels;
  const double reach = detachedReach * scene.spacing;
  const auto solid = [&](std::size_t i) { return !f.liquid.active || f.liquid[i] < 0.5f; };
  const auto cold = [&](std::size_t i) { return !f.liquid.active || f.liquid[i] < 0.02f; };
  const auto softens = [&](std::size_t i) {
    return !cold(i) && f.maxLiquidFraction.active && f.maxLiquidFraction[i] > 0;
  };
  std::vector<Vec3d> grown;
  std::vector<std::uint32_t> row;
  for (std::uint32_t i = 0; i < f.size(); i++)
    if (f.detail[i] < 0.5f && cold(i)) grown.push_back(f.position[i]), row.push_back(i);
  Bins bins;
  fillBins(grown.data(), grown.size(), reach, bins);
  dead.assign(f.owned, 0);
  std::vector<std::uint8_t> probed(f.owned, 0);
  RowBlock block;
  // All grown surfels of this rank are tested, except those that follow their reference. Another sheet nearby
  // may disturb the colour there.
  for (std::uint32_t i = 0; i < f.owned; i++)
    if (f.detail[i] < 0.5f && solid(i) && !(f.hasReference.active && f.hasReference[i])) probed[i] = 1;
  if (!grown.empty())
    forBlocks(t.relax.surfelBins, bins, reach, block, [&](std::uint32_t i, RowBlock& around) {
      if (i >= f.owned || !solid(i) || f.detail[i] < 0.5f) return;
      // Meshes resolve more detail than particles, and lie up to one spacing above the particles' surface.
      bool beside = false;
      double nearest2 = spurReach * spurReach * scene.spacing * scene.spacing;
      std::uint32_t face = 0xffffffffu;
      for (const std::uint32_t k : around.around(f.position[i], reach)) {
        const std::uint32_t j = row[around.row[k]];
        const Vec3d d = around.at[k] - f.position[i];
        const double d2 = dot(d, d);
        if (d2 > reach * reach || f.component[j] != f.component[i]) continue;
        beside = true;
        if (!(f.id[j] & birthBit) || !cold(i)) continue;
        if (dot(f.normal[i], f.normal[j]) > spurTurn || d2 > nearest2 ||
            (d2 == nearest2 && face != 0xffffffffu && f.id[j] > f.id[face]))
          continue;
        nearest2 = d2;
        face = j;
      }
      if (!beside) return;
      if (face != 0xffffffffu) {
        const Vec3d d = f.position[i] - f.position[face];
        // The face lies behind the surfel, so the edge is convex.
        if (dot(d, f.normal[face]) > spurHeight * scene.spacing && dot(d, f.normal[i]) > 0) {
          dead[i] = 1;
          return;
        }
      }
      probed[i] = 1;
    });
  forFieldAtSurfels(scene, surface, t, probed, [&](std::size_t i, const FieldSample& c) {
    const double slope = length(c.gradient), along = slope > 0 ? -dot(c.gradient, f.normal[i]) / slope : -1;
    const double under = c.value / c.level - 1;
    // A mesh may begin half a spacing inside the particles' surface. The iterations move softening surfels
    // outward from there.
    dead[i] = f.detail[i] >= 0.5f
                  ? under < -mostMeshOutward || along < -0.2
                  : under < -mostOutward || (under > mostInward && !softens(i)) || along < 0.5;
  });
}

/// Lets grown surfels near new ones relax, because an opening crack moves the surface next to its new faces.
/// Requires: surfels with ghosts.
void relaxAroundNew(const Scene& scene, Surfels& f) {
  const double reach = relaxingReach * scene.spacing;
  std::vector<Vec3d> relaxesOnce;
  std::vector<std::uint64_t> component;
  for (std::size_t i = 0; i < f.size(); i++)
    if (f.relaxesOnce[i]) relaxesOnce.push_back(f.position[i]), component.push_back(f.component[i]);
  Bins bins;
  fillBins(relaxesOnce.data(), relaxesOnce.size(), reach, bins);
  for (std::size_t i = 0; i < f.owned && !relaxesOnce.empty(); i++) {
    if (f.relaxesOnce[i] || f.detail[i] >= 0.5f) continue;
    forRowsWithin(bins, f.position[i], reach,
                  [&](std::uint32_t j, double) { f.relaxesOnce[i] |= component[j] == f.component[i]; });
  }
}

}  // namespace

std::int64_t resurfaceExposed(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  prepareParticles(w.scene, w.surface, halos, t);
  const bool coloured = coloursMayDiffer(w.scene);
  const auto placeSurfels = [&] {
    placeRows(s.grid, halos.surfels, f, s.surfelCells, t.sort);
    ColumnList columns{&f.id, &f.position, &f.normal, &f.radius, &f.component, &f.detail};
    if (f.liquid.active) columns.push_back(&f.liquid);
    if (f.relaxesOnce.active) columns.push_back(&f.relaxesOnce);
    if (f.hasReference.active) columns.push_back(&f.hasReference);
    if (coloured) columns.push_back(&f.colour);
    addGhosts(halos.surfels, f, s.surfelCells, columns);
    fillBins(s.grid, s.surfelCells, f.position.data(), surfelReach * w.scene.spacing, t.relax.surfelBins);
  };
  std::int64_t all = 0;
  for (int round = 0; round < mostRounds; round++) {
    placeSurfels();
    if (round == 0) uncoverBesideLiquid(w.scene, t, s);
    std::vector<std::uint8_t> dead;
    findDetached(w.scene, w.surface, t, dead);
    std::int64_t count[2] = {0, std::count(dead.begin(), dead.end(), 1)};
    halos.all.sum({count + 1, 1});
    if (count[1] > 0) {
      removeSurfels(s, dead);
      placeSurfels();
    }
    std::vector<SurfelRow> rows;
    // Without deletions, all seeds would be rejected again.
    if (round == 0 || count[1] > 0) {
      ExposedSeeder seeder(w, t, rows);
      for (std::size_t bin = 0; bin < t.relax.particleBins.size(); bin++) seeder.seedBin(bin);
    }
    if (coloured) inheritColours(w.scene, w.surface, t.relax.surfelBins, rows);
    count[0] = static_cast<std::int64_t>(rows.size());
    halos.all.sum({count, 1});
    f.resize(f.owned, 0);
    if (count[0] > 0) {
      f.activate(f.relaxesOnce);
      addSurfels(f, rows, w.scene.seed, halos.all);
    }
    s.counters.births += count[0];
    s.counters.deaths += count[1];
    all += count[0];
    if (count[0] == 0) break;
  }
  if (all > 0) {
    placeSurfels();
    relaxAroundNew(w.scene, f);
    f.resize(f.owned, 0);
  }
  return all;
}

}  // namespace thaw
