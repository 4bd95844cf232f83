// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/blend.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "core/surface/advection/displace.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "tests/support/surface/relax_rig.hpp"

namespace thaw {
namespace {

using test::RelaxRig;

/// A ball of radius 6 with bumps of 0.3 on its surfels and a uniform liquid fraction.
struct Bumpy {
  RelaxRig rig{0.5, 12};
  static double bump(const Vec3d& e) { return 0.3 * std::sin(4 * e.x) * std::sin(4 * e.y + 1); }

  Bumpy() {
    rig.addLattice(7, {0.5, 0.5, 0.5}, [](const Vec3d& x) { return length(x) < 6; });
    rig.addBallSurfels(6);
    Surfels& s = rig.w.surface.surfels;
    s.activate(s.maxLiquidFraction);
    s.activate(s.detailHeight);
    for (std::size_t i = 0; i < s.owned; i++) s.position[i] += bump(normalized(s.position[i])) * s.normal[i];
  }
  void update(double liquid, const Vec3d& by = {}) {
    Surface& f = rig.w.surface;
    const SurfaceHalos halos = rig.ranks->halos();
    SurfaceParticles& p = f.particles;
    p.resize(p.owned, 0);
    for (std::size_t i = 0; i < p.owned; i++)
      p.liquid[i] = static_cast<float>(liquid), p.displacement[i] = by;
    rig.place();
    findDisplacementGradients(rig.w.grid, rig.w.surface, halos, rig.tools);
    displaceSurfels(rig.w.scene, rig.w.surface, halos, rig.tools);
    p.resize(p.owned, 0);
    for (std::size_t i = 0; i < p.owned; i++) p.position[i] += by;
    rig.place();
    sampleFields(rig.w.scene, rig.w.surface, halos, rig.tools);
    rig.relaxSurfels(60, false);
    blendSurfels(rig.w.surface.surfels);
    middle += by;
  }
  /// Remaining share of the bumps, by projection onto the initial ones.
  double left() const {
    const Surfels& s = rig.w.surface.surfels;
    double with = 0, all = 0, mean = 0;
    for (std::size_t i = 0; i < s.owned; i++)
      mean += length(s.position[i] - middle) / static_cast<double>(s.owned);
    for (std::size_t i = 0; i < s.owned; i++) {
      const Vec3d d = s.position[i] - middle;
      const double b = bump(normalized(d));
      with += b * (length(d) - mean), all += b * b;
    }
    return with / all;
  }
  Vec3d middle{};
};

/// b rises to `most` in some updates and stays for as many. The remaining share does not depend on the rate.
TEST(Blend, DetailDoesNotDependOnTheNumberOfUpdates) {
  for (const double most : {0.3, 0.6}) {
    double first = 0;
    for (const int updates : {1, 4, 20}) {
      Bumpy ball;
      const Vec3d way{1, 0.3, 0};
      for (int k = 1; k <= 2 * updates; k++)
        ball.update(most * std::min(1.0, static_cast<double>(k) / updates), 0.5 / updates * way);
      const double left = ball.left();
      std::printf("b %.1f, %2d updates: %.4f of the bumps left\n", most, 2 * updates, left);
      if (updates == 1) first = left;
      EXPECT_NEAR(left, first, 0.03);
      EXPECT_NEAR(left, 1 - most, 0.06);  // the smooth surface contains part of their shape
      const Surfels& s = ball.rig.w.surface.surfels;
      double detail = 0;
      for (std::size_t i = 0; i < s.owned; i++)
        detail += static_cast<double>(s.detail[i]) / static_cast<double>(s.owned);
      EXPECT_NEAR(detail, 1 - most, 0.03);
    }
  }
}

TEST(Blend, FrozenSurfacesKeepTheirDetail) {
  Bumpy ball;
  const Surfels& s = ball.rig.w.surface.surfels;
  for (const double b : {0.2, 0.5, 0.5}) ball.update(b);
  const double half = ball.left();
  for (const double b : {0.4, 0.3, 0.1, 0.02}) ball.update(b);
  EXPECT_NEAR(ball.left(), half, 0.01);
  const std::vector<Vec3d> before(s.position.data(), s.position.data() + s.owned);
  for (int k = 0; k < 3; k++) ball.update(0);
  for (std::size_t i = 0; i < s.owned; i++) EXPECT_LT(length(s.position[i] - before[i]), 1e-12);
  for (int k = 0; k < 4; k++) ball.update(0.5);  // molten again, it loses half of the rest
  EXPECT_NEAR(ball.left(), 0.5 * half, 0.06);
  ball.update(1);
  for (std::size_t i = 0; i < s.owned; i++) EXPECT_EQ(s.detail[i], 0);
}

/// Half-molten material that flows loses its detail at any rate of updates; solid material keeps it.
TEST(Blend, DeformationErasesDetailOfMoltenSurfaces) {
  const auto knead = [](double liquid, int updates) {
    Bumpy ball;
    Surfels& s = ball.rig.w.surface.surfels;
    ball.update(liquid);
    for (int k = 0; k < updates; k++) {  // a total strain of 1, without the motion
      s.activate(s.carried);
      s.activate(s.carriedNormal);
      s.activate(s.strain);
      for (std::size_t i = 0; i < s.owned; i++)
        s.carried[i] = s.position[i], s.carriedNormal[i] = s.normal[i],
        s.strain[i] = static_cast<float>(1.0 / updates);
      ball.rig.relaxSurfels(60, false);
      blendSurfels(ball.rig.w.surface.surfels);
    }
    return ball.left();
  };
  EXPECT_NEAR(knead(0, 5), 1, 1e-9);
  const double once = knead(0.5, 1);
  EXPECT_NEAR(once, 0.5 * std::exp(-1), 0.05);
  EXPECT_NEAR(knead(0.5, 10), once, 0.02);
}

}  // namespace
}  // namespace thaw
