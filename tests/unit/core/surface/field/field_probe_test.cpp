// SPDX-License-Identifier: Apache-2.0
#include "core/surface/field/iso_surface.hpp"

#include <gtest/gtest.h>

#include "core/surface/field/prepare_particles.hpp"
#include "tests/support/surface/relax_rig.hpp"

namespace thaw {
namespace {

using test::RelaxRig;

TEST(FieldProbe, FindsTheSumOverParticlesWithItsGradient) {
  RelaxRig rig;
  rig.addLattice(6, {0.3, 0.1, 0.2}, [](const Vec3d& x) { return length(x) < 5.5; });
  rig.addParticle({0, 0, 6.5}, {}, 9);  // another body
  rig.place();
  prepareParticles(rig.w.scene, rig.w.surface, rig.ranks->halos(), rig.tools);
  const SurfaceParticles& p = rig.w.surface.particles;
  const double h = rig.w.surface.particleSupport;
  std::vector<FieldSample> first;
  for (const char* isa : {"base", "avx2", "avx512"}) {
    if (!surfaceKernels(isa)) continue;
    rig.tools.relax.kernels = surfaceKernels(isa);
    FieldProbe probe(rig.w.scene, rig.w.surface, rig.tools);
    std::vector<Vec3d> x;
    std::vector<FieldSample> found(FieldProbe::most);
    for (int k = 0; k < 7; k++) x.push_back({0.1 * k, 0.2, 5.9 - 0.1 * k});
    PlaceBox box{x[0], x[0]};
    for (const Vec3d& at : x) box.add(at);
    probe.around(box, 1, 0.5 * (box.low + box.high));
    probe.at(x.data(), x.size(), found.data());
    for (std::size_t k = 0; k < x.size(); k++) {
      double value = 0;
      Vec3d gradient{};
      for (std::size_t j = 0; j < p.size(); j++) {
        const Vec3d d = x[k] - p.position[j];
        const double u = 1 - dot(d, d) / (h * h),
                     v = static_cast<double>(rig.tools.relax.particle[4 * j + 3]);
        if (u <= 0 || p.component[j] != 1) continue;
        value += v * u * u * u;
        gradient -= (6 * v * u * u / (h * h)) * d;
      }
      EXPECT_NEAR(found[k].value, value, 1e-5 * value);
      EXPECT_LT(length(found[k].gradient - gradient), 1e-4 * length(gradient));
    }
    if (first.empty()) first = found;
    for (std::size_t k = 0; k < x.size(); k++)
      EXPECT_TRUE(found[k].value == first[k].value && found[k].gradient == first[k].gradient &&
                  found[k].level == first[k].level)
          << isa;
  }
}

TEST(FieldProbe, NewtonFindsTheSurfaceOrReportsNone) {
  RelaxRig rig;
  rig.addLattice(6, {0.3, 0.1, 0.2}, [](const Vec3d& x) { return length(x) < 5.5; });
  rig.place();
  prepareParticles(rig.w.scene, rig.w.surface, rig.ranks->halos(), rig.tools);
  FieldProbe probe(rig.w.scene, rig.w.surface, rig.tools);
  const std::array<Vec3d, 4> from{{{0, 0, 5}, {0, 0.4, 5}, {0.4, 0, 5.2}, {0, 0, 12}}};
  std::array<std::optional<SurfacePoint>, 4> found;
  projectToIsoSurface(probe, {1, from[0], 1.5}, from, found.data());
  EXPECT_FALSE(found[3]);
  for (std::size_t k = 0; k < 3; k++) {
    ASSERT_TRUE(found[k]);
    EXPECT_NEAR(length(found[k]->position), 5.5, 0.25);
    EXPECT_GT(dot(found[k]->normal, normalized(found[k]->position)), 0.95);
    std::optional<SurfacePoint> alone;
    projectToIsoSurface(probe, {1, from[0], 1.5}, {&from[k], 1}, &alone);
    ASSERT_TRUE(alone);
    EXPECT_TRUE(alone->position == found[k]->position && alone->normal == found[k]->normal);
  }
}

// The particles of other ranks are present as far as the surrounding cells, and farther on fewer ranks.
// Queries far from the owned cells must not depend on that.
TEST(FieldProbe, DoesNotDependOnRemoteParticles) {
  std::vector<FieldSample> found;
  for (const bool more : {false, true}) {
    RelaxRig rig;
    rig.addLattice(9, {0.3, 0.1, 0.2}, [](const Vec3d& x) { return std::abs(x.z) < 2 && std::abs(x.y) < 5; });
    rig.place();
    prepareParticles(rig.w.scene, rig.w.surface, rig.ranks->halos(), rig.tools);
    SurfaceParticles& p = rig.w.surface.particles;
    const Vec3d home{0, 0, 1.5}, away{1.2, 0, 2.2};
    const Vec3d& edge = rig.w.surface.grid.edge;
    if (!more)
      for (std::size_t j = 0; j < p.owned; j++)
        if (length(p.position[j] - home) > std::min({edge.x, edge.y, edge.z})) p.component[j] = 9;
    FieldProbe probe(rig.w.scene, rig.w.surface, rig.tools);
    probe.around({away, away}, 1, home);
    probe.at(&away, 1, &found.emplace_back());
  }
  EXPECT_GT(found[0].value, 0);
  EXPECT_TRUE(found[0].value == found[1].value && found[0].gradient == found[1].gradient &&
              found[0].level == found[1].level);
}

}  // namespace
}  // namespace thaw
