// SPDX-License-Identifier: Apache-2.0
// Inputs and outputs of surfel relaxation: levels, normals of few neighbours, fields, detail.
#include "core/surface/relaxation/relax.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "core/surface/data/level_table.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/relaxation/blend.hpp"
#include "tests/support/surface/relax_rig.hpp"

namespace thaw {
namespace {

using test::addBall;
using test::places;
using test::RelaxRig;

TEST(Relax, LevelTableHasItsDerivative) {
  LevelTable table;
  table.fill();
  for (const double x : {0.1, 0.35, 0.5, 0.7}) {
    const double step = 1e-2;
    EXPECT_NEAR(table.slope(x), (table.level(x + step) - table.level(x - step)) / (2 * step),
                0.1 * table.slope(x) + 1e-3)
        << x;
  }
}

TEST(Relax, DegenerateNeighbourhoodsStayFinite) {
  for (SmoothingForm form : {SmoothingForm::Sphere, SmoothingForm::Plane}) {
    RelaxRig rig(0.5, 12, [&](Scene& s) { s.surface.smoothing = form; });
    const auto finite = [&] {
      const Surfels& s = rig.w.surface.surfels;
      for (std::size_t i = 0; i < s.owned; i++) {
        EXPECT_TRUE(std::isfinite(dot(s.position[i], s.position[i])));
        EXPECT_NEAR(length(s.normal[i]), 1, 1e-12);
        EXPECT_NEAR(dot(s.normal[i], s.tangent[i]), 0, 1e-9);
      }
    };
    rig.relaxSurfels(3);  // nothing
    rig.addSurfel({0, 0, 1}, {0, 0, 1});
    rig.place();
    rig.relaxSurfels(3);  // one surfel, no particle
    EXPECT_EQ(rig.w.surface.surfels.position[0], (Vec3d{0, 0, 1}));
    rig.addParticle({});
    rig.place();
    rig.relaxSurfels(3);
    finite();
    for (int k = 1; k < 6; k++) rig.addSurfel({0.2 * k, 0, 1}, {0, 0, 1});  // a row
    rig.place();
    rig.relaxSurfels(3);
    finite();
    if (form == SmoothingForm::Plane) { EXPECT_GT(rig.w.surface.counters.keptNormals, 0); }
    for (int k = 0; k < 3; k++) rig.addSurfel({0, 1, 0}, {0, 1, 0});  // at one position
    rig.place();
    rig.relaxSurfels(3);
    finite();
    EXPECT_EQ(places(rig.w.surface.surfels).size(), 9u);
    for (std::size_t i = 0; i < 9; i++)
      for (std::size_t j = 0; j < i; j++)
        EXPECT_GT(length(rig.w.surface.surfels.position[i] - rig.w.surface.surfels.position[j]), 1e-3);
  }
}

TEST(Relax, NormalIsKeptWithoutAPlaneOfNeighbours) {  // stability row 23
  RelaxRig rig(0.5, 12, [](Scene& s) {
    s.surface.implicit = s.surface.attract = s.surface.repel = 0, s.surface.smooth = 0.5,
    s.surface.smoothing = SmoothingForm::Plane;
  });
  const Vec3d up = normalized({0.3, 0.4, 1});
  rig.addSurfel({0, 0, 0}, up);
  for (int a = 0; a < 3; a++)
    for (const double side : {-0.5, 0.5}) {  // isotropic: three equal eigenvalues
      Vec3d x{};
      x[a] = side;
      rig.addSurfel(x, up);
    }
  rig.place();
  rig.relaxSurfels(1);
  const Surfels& s = rig.w.surface.surfels;
  for (std::size_t i = 0; i < s.owned; i++)
    if (s.id[i] == 1000) { EXPECT_LT(length(s.normal[i] - up), 1e-6); }
  EXPECT_GT(rig.w.surface.counters.keptNormals, 0);
}

TEST(Relax, NormalsAgainstTheColourFieldAreTurnedAndCounted) {
  RelaxRig rig;
  addBall(rig, 5);
  rig.w.surface.surfels.normal[3] = -rig.w.surface.surfels.normal[3];
  rig.relaxSurfels(10);
  EXPECT_EQ(rig.w.surface.counters.flipped, 1);
  EXPECT_LT(test::ballErrors(rig.w.surface.surfels, 5).normalMax, 20);
}

TEST(Relax, BlendKeepsSolidsAndFadesDetail) {
  RelaxRig rig;
  Surfels& s = rig.w.surface.surfels;
  rig.addSurfel({1, 0, 0}, {1, 0, 0}, 1, 0);
  rig.addSurfel({2, 0, 0}, {1, 0, 0}, 1, 0.25f);
  rig.addSurfel({3, 0, 0}, {1, 0, 0}, 1, 1);
  s.activate(s.carried);
  s.activate(s.carriedNormal);
  for (std::size_t i = 0; i < 3; i++) {
    s.carried[i] = s.position[i];
    s.carriedNormal[i] = s.normal[i];
    s.position[i].x += 1;
    s.normal[i] = {0, 1, 0};
  }
  blendSurfels(rig.w.surface.surfels);
  EXPECT_EQ(s.position[0].x, 1);
  EXPECT_EQ(s.position[1].x, 2.25);
  EXPECT_EQ(s.position[2].x, 4);
  EXPECT_EQ(s.normal[0], (Vec3d{1, 0, 0}));
  EXPECT_NEAR(s.normal[1].y / s.normal[1].x, 1.0 / 3, 1e-12);
  EXPECT_EQ(s.normal[2], (Vec3d{0, 1, 0}));
  EXPECT_EQ(s.detail[0], 1);
  EXPECT_EQ(s.detail[1], 0.75f);
  EXPECT_EQ(s.detail[2], 0);
  EXPECT_FALSE(s.carried.active);
}

TEST(Relax, FieldsAreMeansOfTheParticlesAround) {
  RelaxRig rig;
  rig.addParticle({-1, 0, 0}, {}, 1, 0);
  rig.addParticle({1, 0, 0}, {}, 1, 1);
  rig.addParticle({0, 0.5, 0}, {}, 2, 1);
  rig.addSurfel({0, 0, 0}, {0, 0, 1});
  rig.place();
  sampleFields(rig.w.scene, rig.w.surface, rig.ranks->halos(), rig.tools);
  EXPECT_NEAR(rig.w.surface.surfels.liquid[0], 0.5, 1e-6);
}

}  // namespace
}  // namespace thaw
