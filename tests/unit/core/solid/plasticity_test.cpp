#include "core/solid/plasticity.hpp"

#include <gtest/gtest.h>

#include "core/solid/laws/response.hpp"
#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

TEST(Plasticity, uniaxialPlateau) {
  Material m = elasticMaterial(1e6, 0.3);
  m.yieldStrain = {0.01, 0.01};
  m.creepRate = {never, never};
  const ElasticConstants c = elasticConstants(m, 0);
  Sym3d plastic{};
  for (double e = 0; e < 0.1; e += 0.001) {
    const Sym3d strain{e, -0.5 * e, -0.5 * e, 0, 0, 0};
    plastic = plasticFlow(c, strain, plastic, 1e-3);
    if (e < 0.03) continue;
    Sym3d s = strain - plastic;
    const double p = trace(s) / 3;
    s = s - Sym3d{p, p, p, 0, 0, 0};
    const double equivalent = std::sqrt(1.5) * 2 * c.mu * norm(s);
    EXPECT_NEAR(equivalent, std::sqrt(1.5) * 2 * c.mu * 0.01, 1e-12 * equivalent);
  }
}

TEST(Plasticity, limitIsKept) {
  Material m = elasticMaterial();
  m.yieldStrain = {0.01, 0.01};
  m.creepRate = {never, never};
  m.maxPlasticStrain = 0.05;
  Sym3d plastic{};
  for (int n = 0; n < 50; n++) plastic = plasticFlow(elasticConstants(m, 0), {0.01 * n, -0.005 * n, 0, 0.003 * n, 0, 0}, plastic, 1e-3);
  EXPECT_NEAR(norm(plastic), 0.05, 1e-15);
}

TEST(Plasticity, creepDoesNotDependOnTheStep) {
  Material m = elasticMaterial();
  m.yieldStrain = {0, 0};
  m.creepRate = {4, 4};
  const ElasticConstants c = elasticConstants(m, 0);
  const Sym3d strain{0.02, -0.01, -0.01, 0.005, 0, 0};
  for (const int steps : {1, 10, 100}) {
    Sym3d plastic{};
    for (int n = 0; n < steps; n++) plastic = plasticFlow(c, strain, plastic, 0.5 / steps);
    EXPECT_NEAR(norm(strain - plastic), norm(strain) * std::exp(-2.0), 1e-14);
  }
}

TEST(Plasticity, lossIsTheDropOfEnergy) {
  for (const ElasticLaw law : {ElasticLaw::Green, ElasticLaw::NeoHookean, ElasticLaw::Corotated}) {
    Material m = elasticMaterial();
    m.law = law;
    m.yieldStrain = {0.01, 0.01};
    m.creepRate = {100, 100};
    const ElasticConstants c = elasticConstants(m, 0);
    const Mat3d g{{{0.1, 0.05, 0}, {0, -0.03, 0.02}, {0.01, 0, -0.06}}};
    const Sym3d before{0.01, -0.01, 0, 0, 0, 0};
    const Sym3d strain = symmetric(0.5 * (transpose(identity3<double>() + g) * (identity3<double>() + g) - identity3<double>()));
    const Sym3d after = plasticFlow(c, strain, before, 1e-3);
    const double drop = elasticResponse(c, g, before).energy - elasticResponse(c, g, after).energy;
    EXPECT_GT(drop, 0);
    EXPECT_NEAR(plasticLoss(c, strain, before, after), drop, 1e-10 * drop);
  }
}

TEST(Plasticity, pushForwardIsObjective) {
  // a rotated body's stress turns with it: push forward at F, then rotate by r, equals rotate first, then push forward
  const Mat3d one = identity3<double>(), r = rotation({1, 1, 0}, 1.5707963267948966);
  const Mat3d f = one + Mat3d{{{0.3, 0.1, 0}, {0, -0.1, 0.2}, {0.1, 0, 0.05}}};
  const Sym3d plastic{0.2, -0.1, -0.05, 0.05, 0.02, 0};
  const Mat3d direct = full(pushForward(r * f - one, plastic)), turned = r * (full(pushForward(f - one, plastic)) * transpose(r));
  EXPECT_LT(largest(direct - turned), 1e-12);
  EXPECT_GT(largest(direct - full(pushForward(f - one, plastic))), 1e-2);
}

TEST(Plasticity, loadingABodyGivesThePlateauAndBooksTheLoss) {
  const auto points = lattice({4, 4, 4}, 0.1, 0.2);
  Material m = elasticMaterial(1e6, 0.3);
  m.yieldStrain = {0.01, 0.01};
  m.creepRate = {never, never};
  const auto b = makeBody(points, {m});
  b->step.dt = 1e-3;
  moveAll(*b, points, [](const Vec3d& x) { return Vec3d{1.05 * x.x, x.y, x.z}; });
  computeForces(*b);
  const ElasticConstants c = elasticConstants(m, 0);
  const Sym3d strain{0.05125, 0, 0, 0, 0, 0};
  for (std::size_t s = 0; s < points.size(); s++) {
    EXPECT_LT(norm(b->solids.plasticStrain[s] - plasticFlow(c, strain, {}, 1)), 1e-12);
    EXPECT_NEAR(b->solids.dissipated[s], 1e-3 * plasticLoss(c, strain, {}, b->solids.plasticStrain[s]), 1e-10);
  }
}
