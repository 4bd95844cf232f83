// SPDX-License-Identifier: Apache-2.0
// Sampled surfaces, resampling and adapted density: the same surfels, bit by bit, on any number of ranks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/halo/serial.hpp"
#include "core/simulation/setup/prepare_surface.hpp"
#include "core/simulation/views/views.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/resampling/resample.hpp"
#include "core/surface/seeding/sample_mesh.hpp"
#include "core/surface/update_surface.hpp"
#include "parallel/row_scatter.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

Scene sceneOf(double adapt) {
  Scene s;
  s.spacing = 0.1;
  s.domain.min = {-1, -1, -1};
  s.domain.max = {1, 1, 1};
  s.surface.on = true;
  s.surface.spacing = 0.05;
  s.surface.adapt = adapt;
  Body b;
  b.shape.kind = ShapeKind::Mesh;
  b.shape.mesh = "capsule";
  s.bodies.push_back(b);
  return s;
}

/// Deforms a ball to a lens, so that the curvature varies, then stretches and compresses it with resampling.
template<class Ranks> void play(World& w, SurfaceTools& t, Ranks& ranks) {
  w.grid.support = 2 * w.scene.spacing;
  Modules m;
  m.fluid = true;
  activateSurfaceFields(w.surface, m, false);
  Surfels& s = w.surface.surfels;
  const auto load = [](const std::string&) {
    TriangleMesh mesh = ballMesh({}, 0.5, 0.07);
    for (Vec3d& v : mesh.vertices) v.z *= 0.4;
    return mesh;
  };
  sampleMeshes(w.scene, w.surface, load, ranks.all);
  for (std::size_t i = 0; i < s.owned; i++) s.component[i] = 1;
  double stretch = 1;
  for (const double to : {1.0, 1.3, 1.6, 1.9, 1.4, 1.0}) {
    w.clock.step++;
    for (std::size_t i = 0; i < s.owned; i++) {
      s.position[i].x *= to / stretch;
      s.normal[i] = normalized({s.normal[i].x * stretch / to, s.normal[i].y, s.normal[i].z});
      s.tangent[i] = normalized(s.tangent[i] - s.normal[i] * dot(s.normal[i], s.tangent[i]));
      s.resampleMargin[i] = 0;  // this test moves it
    }
    stretch = to;
    resample(surfaceView(w), ranks.halos(), t, 6);
  }
}

void expectSame(double adapt) {
  World alone, shared;
  alone.scene = shared.scene = sceneOf(adapt);
  SurfaceTools t, u;
  alone.grid.support = shared.grid.support = 0.2;
  prepareSurface(alone);
  prepareSurface(shared);
  SerialSurfaceRanks one(alone.surface.grid);
  play(alone, t, one);
  const Communicator comm;
  SurfaceRanks all(comm, shared.surface.grid);
  play(shared, u, all);
  EXPECT_EQ(alone.surface.counters.births, shared.surface.counters.births);
  EXPECT_EQ(alone.surface.counters.deaths, shared.surface.counters.deaths);
  EXPECT_GT(alone.surface.counters.births, 100);
  EXPECT_GT(alone.surface.counters.deaths, 100);
  // every row equals one of the single process, and the numbers agree
  const Surfels &a = alone.surface.surfels, &b = shared.surface.surfels;
  std::int64_t count = static_cast<std::int64_t>(b.owned);
  all.all.sum({&count, 1});
  EXPECT_EQ(count, static_cast<std::int64_t>(a.owned));
  std::vector<std::size_t> byId(a.owned);
  for (std::size_t i = 0; i < a.owned; i++) byId[i] = i;
  std::sort(byId.begin(), byId.end(), [&](std::size_t i, std::size_t j) { return a.id[i] < a.id[j]; });
  std::vector<std::byte> x(a.stateBytes()), y(b.stateBytes());
  std::int64_t wrong = 0;
  for (std::size_t i = 0; i < b.owned; i++) {
    const auto at = std::lower_bound(byId.begin(), byId.end(), b.id[i],
                                     [&](std::size_t k, std::uint64_t id) { return a.id[k] < id; });
    if (at == byId.end() || a.id[*at] != b.id[i]) {
      wrong++;
      continue;
    }
    a.packState(*at, x.data());
    b.packState(i, y.data());
    wrong += std::memcmp(x.data(), y.data(), x.size()) != 0;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(SurfelSampling, IsTheSameOnAnyNumberOfRanks) { expectSame(0); }
TEST(SurfelSampling, IsTheSameWithAdaptedDensity) { expectSame(0.4); }

}  // namespace
}  // namespace thaw
