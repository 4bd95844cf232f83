// SPDX-License-Identifier: Apache-2.0
// A tearing solid: the faces of the crack get a surface, and each piece is closed.
#include "core/surface/seeding/resurface_exposed.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "core/simulation/views/views.hpp"
#include "core/surface/measures/measure.hpp"
#include "core/surface/seeding/grow.hpp"
#include "core/surface/update_components.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/surface/surface_world.hpp"
#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using namespace test;

Scene barScene(bool mesh, double spacing) {
  Scene s = emptyScene(0.1, {-3, -2, -2}, {3, 2, 2});
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e5, 0};
  s.surface.on = true;
  s.surface.spacing = spacing;
  addBox(s, {-1, -0.4, -0.4}, {1, 0.4, 0.4});
  if (!mesh) s.surface.source = SurfelSource::Particles;
  if (mesh)
    s.bodies[0].shape = Shape{}, s.bodies[0].shape.kind = ShapeKind::Mesh, s.bodies[0].shape.mesh = "bar";
  return s;
}

struct TornBar : SurfaceWorld {
  explicit TornBar(bool mesh, bool coloured = false, double spacing = 0.05)
      : SurfaceWorld(barScene(mesh, spacing), [coloured](const std::string&) {
          TriangleMesh bar = boxMesh({-1, -0.4, -0.4}, {1, 0.4, 0.4});
          if (coloured) bar.colours.assign(bar.vertices.size(), 0x2030c0);
          return bar;
        }) {}
  /// Separates two pieces along a curved crack.
  void pull(double by) {
    for (std::size_t i = 0; i < w.particles.owned; i++) {
      Vec3d& x = w.particles.position[i];
      x.x += 0.5 * by * (right(i) ? 1 : -1);
    }
    update();
  }
  bool right(std::size_t i) {
    if (side.empty()) {
      side.resize(w.particles.owned);
      for (std::size_t k = 0; k < side.size(); k++) {
        const Vec3d& y = w.particles.position[k];
        side[w.particles.id[k]] = y.x > 0.2 * std::sin(5 * y.y) + 0.3 * y.z;
      }
      cut();
    }
    return side[w.particles.id[i]];
  }
  /// Applies the effect of a crack to particles with bonds across it (bond_graph.cpp).
  void cut() {
    const Continuum& p = w.particles;
    for (std::size_t i = 0; i < p.owned; i++)
      for (std::size_t j = 0; j < p.owned; j++)
        if (side[p.id[i]] != side[p.id[j]] &&
            length(p.position[i] - p.position[j]) < w.scene.numerics.bondSupport * w.scene.spacing)
          w.solids.exposed[p.solidIndex[i]] = 1;
  }
  std::vector<char> side;
};

/// Largest distance, over the spacing, between the surface and a new one grown around the same particles, in
/// both directions and on the same side. `open`: largest openness of the new one by its areas
/// (SurfaceComponent::open).
struct AwayFromFresh {
  double hole = 0, off = 0, open = 0;
};
AwayFromFresh awayFromFresh(TornBar& torn, double inside) {
  SurfelRig fresh(surfelScene(0.05));
  SurfaceParticles& p = fresh.world.surface.particles;
  const Continuum& c = torn.w.particles;
  p.resize(c.owned, 0);
  for (std::size_t i = 0; i < c.owned; i++) {
    p.id[i] = c.id[i];
    p.position[i] = c.position[i];
    p.component[i] = c.component[i];
    p.volume[i] = 1e-3;
    p.liquid[i] = 1;
  }
  placeRows(fresh.world.surface.grid, fresh.ranks->particles, p, fresh.world.surface.particleCells,
            fresh.tools.sort);
  growBodies(surfaceView(fresh.world), fresh.ranks->halos(), fresh.tools);
  const Surfels &a = fresh.surfels(), &b = torn.w.surface.surfels;
  const auto farthest = [&](const Surfels& from, const Surfels& to) {
    double worst = 0;
    for (std::size_t i = 0; i < from.owned; i++) {
      if (std::abs(from.position[i].x) > inside) continue;
      double best = 1e300;
      for (std::size_t j = 0; j < to.owned; j++)
        if (dot(from.normal[i], to.normal[j]) > oneSide && from.component[i] == to.component[j])
          best = std::min(best, dot(from.position[i] - to.position[j], from.position[i] - to.position[j]));
      worst = std::max(worst, std::sqrt(best) / 0.05);
    }
    return worst;
  };
  AwayFromFresh away{farthest(a, b), farthest(b, a)};
  measureSurface(surfaceView(fresh.world), fresh.ranks->halos(), fresh.tools);
  for (const SurfaceComponent& k : fresh.world.surface.components) away.open = std::max(away.open, k.open);
  return away;
}

TEST(ResurfaceExposed, TornBarHasTwoClosedPieces) {
  for (const bool mesh : {false, true}) {
    TornBar bar(mesh);
    const Surface& s = bar.w.surface;
    ASSERT_EQ(s.components.size(), 1u);
    const double volume = s.components[0].volume / s.components[0].particleVolume;
    const std::size_t before = s.surfels.owned;
    for (int k = 0; k < 16; k++) bar.pull(0.025);
    std::vector<std::uint64_t> kept(s.surfels.id.data(), s.surfels.id.data() + s.surfels.owned);
    std::int64_t old = 0;
    for (const std::uint64_t id : kept) old += !(id & birthBit);
    ASSERT_EQ(s.components.size(), 2u);
    EXPECT_EQ(s.counters.splits, 1);
    const auto [hole, off, open] = awayFromFresh(bar, mesh ? 0.6 : 2);
    for (const SurfaceComponent& c : s.components) {
      std::printf(
          "%s: %lld particles, %lld surfels, volume %.4f of the particles' (whole bar %.4f), open %.4f "
          "(new surface at most %.4f)\n",
          mesh ? "mesh" : "grown", static_cast<long long>(c.particles), static_cast<long long>(c.surfels),
          c.volume / c.particleVolume, volume, c.open, open);
      EXPECT_NEAR(c.volume / c.particleVolume / volume, 1, mesh ? 0.03 : 0.02);
      EXPECT_LT(c.open, mesh ? 0.03 : std::max(0.01, 1.1 * open));  // the skin of a mesh ends in a step of
                                                                    // half a particle spacing over the face
    }
    std::printf(
        "%zu surfels, then %zu, %lld births, %lld deaths; %.3f spacings at most from a fresh surface to "
        "surfels, %.3f back\n",
        before, s.surfels.owned, static_cast<long long>(s.counters.births),
        static_cast<long long>(s.counters.deaths), hole, off);
    if (mesh) { EXPECT_GT(static_cast<double>(old), 0.75 * static_cast<double>(before)); }
    EXPECT_LT(hole, mesh ? 1.2 : 1.0);
    EXPECT_LT(off, mesh ? 1.9 : 1.2);  // includes the mesh's edges, which a grown surface rounds
    // and it stays as it is
    const std::int64_t changes = s.counters.births + s.counters.deaths;
    for (int k = 0; k < 3; k++) bar.pull(0);
    std::printf("at rest: %lld births and deaths more\n",
                static_cast<long long>(s.counters.births + s.counters.deaths - changes));
    const std::int64_t later = s.counters.births + s.counters.deaths;
    bar.pull(0);
    EXPECT_EQ(s.counters.births + s.counters.deaths, later);
  }
}

TEST(ResurfaceExposed, FacesOfACrackInheritTheColoursOfTheMesh) {
  TornBar bar(true, true);
  for (int k = 0; k < 16; k++) bar.pull(0.025);
  const Surfels& f = bar.w.surface.surfels;
  std::size_t born = 0;
  for (std::size_t i = 0; i < f.owned; i++) {
    born += (f.id[i] & birthBit) != 0;
    EXPECT_EQ(f.colour[i], 0x2030c0u) << i;
  }
  EXPECT_GT(born, 400u);
  // also with a detached chip and small drops
  std::size_t moved = 0;
  for (std::size_t i = 0; i < bar.w.particles.owned && moved < 3; i++)
    if (const Vec3d x = bar.w.particles.position[i]; x.x > 0.9 && x.y > 0.3 && x.z > 0.1)
      bar.w.particles.position[i] += Vec3d{0.25, 0.25, 0}, moved++;
  bar.update();
  ASSERT_EQ(moved, 3u);
  bar.update();
  const auto small = std::find_if(bar.w.surface.components.begin(), bar.w.surface.components.end(),
                                  [](const SurfaceComponent& c) { return c.particles <= 3; });
  ASSERT_NE(small, bar.w.surface.components.end());
  EXPECT_GT(small->surfels, 20);
  for (std::size_t i = 0; i < f.owned; i++) EXPECT_EQ(f.colour[i], 0x2030c0u) << i;
}

/// A bar compressed across until the colour field's surface lies elsewhere keeps its own. No bond is lost, so
/// no second skin grows.
TEST(ResurfaceExposed, CompressedBodyGrowsNoSecondSkin) {
  for (const bool intact : {true, false}) {
    TornBar bar(true, false, 0.02);
    if (!intact) std::fill_n(bar.w.solids.exposed.data(), bar.w.solids.owned, std::uint8_t{1});
    for (int k = 0; k < 10; k++) {
      for (std::size_t i = 0; i < bar.w.particles.owned; i++) {
        const Vec3d x = bar.place(i);
        bar.place(i) = {x.x + 0.06 * x.z, x.y, x.z * (x.x > 0 ? 0.96 : 1.05)};
      }
      bar.update();
    }
    const Surfels& f = bar.w.surface.surfels;
    std::size_t grown = 0;
    for (std::size_t i = 0; i < f.owned; i++) grown += f.detail[i] < 0.5f;
    std::printf("%s: %zu of %zu surfels are grown\n", intact ? "all bonds" : "bonds lost", grown, f.owned);
    if (intact) {
      EXPECT_EQ(grown, 0u);
    } else {
      EXPECT_GT(grown, 100u);
    }
  }
}

/// A bar that swings through strains of a fifth in ten updates per cycle. Its surfels return to their initial
/// places, and no error accumulates.
TEST(ReferenceMotion, OscillatingBodyKeepsItsDetail) {
  TornBar bar(true);
  const Surfels& f = bar.w.surface.surfels;
  const std::vector<Vec3d> start(bar.w.particles.position.data(),
                                 bar.w.particles.position.data() + bar.w.particles.owned);
  std::map<std::uint64_t, std::pair<Vec3d, Vec3d>> before;
  for (std::size_t i = 0; i < f.owned; i++) before[f.id[i]] = {f.position[i], f.normal[i]};
  for (int k = 1; k <= 30; k++) {
    const double a = 0.2 * std::sin(k * std::numbers::pi / 5);
    for (std::size_t i = 0; i < start.size(); i++) {
      const Vec3d x = start[i];
      bar.place(i) = {x.x * (1 + a), x.y + a * x.x * x.x, x.z * (1 - 0.5 * a) + a * x.x * x.y};
    }
    bar.update();
  }
  double worst = 0, turned = 0;
  std::size_t old = 0;
  for (std::size_t i = 0; i < f.owned; i++) {
    if (!before.contains(f.id[i])) continue;  // born at the largest stretch
    old++;
    const auto& [place, normal] = before[f.id[i]];
    worst = std::max(worst, length(f.position[i] - place) / 0.05);
    turned = std::max(turned, length(f.normal[i] - normal));
  }
  std::printf("%.2e spacings off, normals %.2e\n", worst, turned);
  EXPECT_EQ(old, before.size());
  EXPECT_LT(f.owned - old, 5u);
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(turned, 1e-9);
}

TEST(ResurfaceExposed, ChipOfSixParticlesGetsASurface) {
  SurfelRig rig(surfelScene(0.05));
  SurfaceParticles& p = rig.world.surface.particles;
  for (const Vec3d& x : {Vec3d{-0.46, 0.08, 0.08},
                         {0.48, -0.1, -0.04},
                         {-0.69, -0.82, -0.34},
                         {0.69, 0.83, 0.35},
                         {-0.29, 0.98, 0.51},
                         {0.27, -0.97, -0.56}}) {
    const std::size_t i = p.owned;
    p.resize(i + 1, 0);
    p.id[i] = i;
    p.position[i] = 0.1 * x;
    p.component[i] = 1;
    p.volume[i] = 1e-3;
    p.liquid[i] = 0;
  }
  placeRows(rig.world.surface.grid, rig.ranks->particles, p, rig.world.surface.particleCells, rig.tools.sort);
  measureComponents(rig.world.surface, rig.ranks->halos().all);
  renewSurfels(surfaceView(rig.world), rig.ranks->halos(), rig.tools);
  resampleOnParticles(surfaceView(rig.world), rig.ranks->halos(), rig.tools, 10);
  resurfaceExposed(surfaceView(rig.world), rig.ranks->halos(), rig.tools);
  EXPECT_GT(rig.surfels().owned, 20u);
}

}  // namespace
}  // namespace thaw
