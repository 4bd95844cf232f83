// SPDX-License-Identifier: Apache-2.0
// All registered elastic laws, of the library and of an extension: stresses against finite differences of
// energies, and forces of a body against its energy.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/solid/laws/corotated.hpp"
#include "core/solid/laws/response.hpp"
#include "core/terms/extensions.hpp"
#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// psi = mu/2 (|F|^2 - 3) - mu ln J + lambda/2 (ln J)^2, times 1 + a (|F|^2 - 3)^2 for a key a.
LawResponse logarithmicLaw(const Mat3d& gradU, double lambda, double mu, const LawValues& values) {
  const Mat3d f = identity3<double>() + gradU;
  const double more = dot(f.row[0], f.row[0]) + dot(f.row[1], f.row[1]) + dot(f.row[2], f.row[2]) - 3,
               j = determinant(f), ln = std::log(j), factor = 1 + values[0] * more * more;
  const double psi = 0.5 * mu * more - mu * ln + 0.5 * lambda * ln * ln;
  const Mat3d stress = mu * f + ((lambda * ln - mu) / j) * cofactor(f);
  return {factor * psi, factor * stress + (4 * values[0] * more * psi) * f};
}

/// Returns the names of all registered laws of solids that deform, with one of an extension.
const std::vector<std::string>& allLaws() {
  static const std::vector<std::string> all = [] {
    if (!findExtension("logarithmic"))
      registerExtension({.name = "logarithmic",
                         .about = "logarithmic strain of the volume",
                         .keys = {{"a", "", 0.1, 0, 1, "stiffening"}},
                         .law = {.response = logarithmicLaw}});
    std::vector<std::string> names;
    for (const std::string& name : lawNames())
      if (name != "rigid") names.push_back(name);
    return names;
  }();
  return all;
}

/// Returns the material with this law and the defaults of its keys.
Material materialOf(const std::string& law, double young = 1e6, double poisson = 0.3) {
  Material m = elasticMaterial(young, poisson);
  m.law.name = law;
  for (const ExtensionKey& key : findExtension(law)->keys) m.law.values[key.name] = key.standard;
  return m;
}

/// Returns true if the energy of an inverted particle is finite.
bool allowsInversion(const std::string& law) {
  const Mat3d inverted{{{-2.1, 0.1, 0}, {0, 0.1, 0}, {0.1, 0, -0.1}}};
  return std::isfinite(elasticResponse(elasticConstants(materialOf(law), 0), inverted).energy);
}

Mat3d noiseMatrix(std::uint64_t n, double size) {
  return size * Mat3d{{noise3(n, 1), noise3(n, 2), noise3(n, 3)}};
}

}  // namespace

TEST(Laws, StressIsDerivativeOfEnergy) {
  for (const std::string& law : allLaws())
    for (std::uint64_t n = 0; n < 20; n++) {
      Material m = materialOf(law, 1, 0.3);
      m.volumeStiffness = 0.7;
      const ElasticConstants c = elasticConstants(m, 0);
      const Mat3d plastic{{{-0.05, 0.02, 0.03}, {-0.04, 0.01, -0.02}, {0.01, -0.03, 0.04}}};
      const Mat3d g = noiseMatrix(n, n < 15 ? 0.4 : 1.5);  // the last ones are far away or inverted
      const ElasticResponse r = elasticResponse(c, g, plastic);
      if (n >= 15 && !allowsInversion(law)) continue;
      for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
          const double d = 1e-5;
          Mat3d up = g, down = g;
          up.row[i][k] += d;
          down.row[i][k] -= d;
          const double slope = (elasticResponse(c, up, plastic).energy -
                                elasticResponse(c, down, plastic).energy) /
                               (2 * d);
          EXPECT_NEAR(slope, r.stress.row[i][k], 1e-7 * (1 + largest(r.stress))) << law << ' ' << n;
        }
    }
}

TEST(Laws, SmallStrainsFollowHooke) {
  const Mat3d g{{{1e-6, 2e-6, 0}, {0, -1e-6, 1e-6}, {2e-6, 0, 3e-6}}};
  for (const std::string& law : allLaws()) {
    const Material m = materialOf(law, 2e6, 0.35);
    const double lambda = 2e6 * 0.35 / (1.35 * 0.3), mu = 2e6 / 2.7;
    const Sym3d e = symmetric(g);
    const Mat3d p = elasticResponse(elasticConstants(m, 0), g).stress;
    const Mat3d hookes = full(2 * mu * e) + (lambda * trace(e)) * identity3<double>();
    EXPECT_LT(largest(p - hookes), 1e-5 * largest(hookes)) << law;
  }
}

TEST(Laws, ObjectiveUnderRotation) {
  const Mat3d r = rotation({1, -2, 0.4}, 2.2), one = identity3<double>();
  for (const std::string& law : allLaws()) {
    const Material m = materialOf(law);
    const ElasticConstants c = elasticConstants(m, 0);
    const Mat3d f = one + noiseMatrix(3, 0.3);
    const ElasticResponse a = elasticResponse(c, f - one), b = elasticResponse(c, r * f - one);
    EXPECT_NEAR(a.energy, b.energy, 1e-12 * a.energy + 1e-9);
    EXPECT_LT(largest(r * a.stress - b.stress), 1e-12 * largest(a.stress));
  }
}

TEST(Laws, PrincipalStressesAreThoseOfTheStress) {
  for (const std::string& law : allLaws()) {
    const ElasticConstants c = elasticConstants(materialOf(law), 0);
    const Vec3d stretch{1.2, 0.8, 1.1}, principal = principalKirchhoff(c, stretch);
    const Mat3d g{{{0.2, 0, 0}, {0, -0.2, 0}, {0, 0, 0.1}}}, stress = elasticResponse(c, g).stress;
    for (int k = 0; k < 3; k++)
      EXPECT_NEAR(principal[k], stress.row[k][k] * stretch[k], 1e-12 * length(principal)) << law;
  }
}

TEST(Laws, LibraryAndExtensionsAreInOneRegistry) {
  for (const std::string& law : lawNames()) {
    const Extension* e = findExtension(law);
    ASSERT_NE(e, nullptr) << law;
    EXPECT_TRUE(e->hasLaw() && !e->about.empty()) << law;
    EXPECT_EQ(e->builtIn, e->law.builtIn >= 0) << law;
  }
  EXPECT_THROW(registerExtension({.name = "green", .law = {.response = logarithmicLaw}}),
               std::invalid_argument);
  Material m = elasticMaterial();
  m.law.name = "gren";
  EXPECT_THROW(elasticConstants(m, 0), std::invalid_argument);
}

TEST(Laws, NearestRotationOfInvertedAndSingular) {
  const Mat3d r = rotation({0.3, 1, 2}, 0.7);
  for (const Vec3d d : {Vec3d{1.2, 0.9, 1.1}, Vec3d{1.5, 1, -0.4}, Vec3d{1, 1, 0}, Vec3d{2, 1, 1e-9}}) {
    const Mat3d s{{{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}};
    EXPECT_LT(largest(nearestRotation(r * s) - r), 1e-12);
  }
  const Mat3d zero = nearestRotation(Mat3d{});
  EXPECT_NEAR(determinant(zero), 1, 1e-12);
}

// Eight lanes of several laws, some inverted: each lane's energy equals that of a single evaluation.
TEST(Laws, LanesOfAGroupDoNotDependOnEachOther) {
  const auto points = lattice({5, 3, 3}, 0.1, 0.2);
  for (const double yield : {never, 0.01}) {
    std::vector<Material> materials;
    for (const std::string& law : allLaws()) {
      if (!allowsInversion(law)) continue;
      Material m = materialOf(law, 1e4);
      m.hourglass = 0;
      m.volumeStiffness = 5e3;
      m.yieldStrain = {yield, yield};
      m.creepRate = {20, 20};
      materials.push_back(m);
    }
    BodyOptions options;
    options.material = [&](std::size_t i) { return static_cast<int>(i * i % 7 % materials.size()); };
    const auto b = makeBody(points, materials, options);
    for (std::size_t s = 0; s < points.size(); s++)
      b->solids.position[s] = points[s] + (s % 3 == 0 ? 0.15 : 0.02) * noise3(s, 3);
    b->step.dt = 1e-3;
    const ElasticResult r = computeForces(*b);
    EXPECT_GT(r.inverted, 2);
    EXPECT_LT(r.inverted, 40);
    for (std::size_t s = 0; s < points.size(); s++) {
      const ElasticConstants c = elasticConstants(materials[b->solids.material[s]], 0);
      const Mat3d plastic = b->solids.plasticInverse.active ? b->solids.plasticInverse[s] : Mat3d{};
      const double alone = b->solids.volume[s] *
                           elasticResponse(c, b->solids.deformation[s] - identity3<double>(), plastic).energy;
      EXPECT_NEAR(b->solids.energy[s], alone, 1e-11 * (std::abs(alone) + 1)) << s;
    }
  }
}

/// Returns the largest difference between forces and differences of the total energy, over the largest force.
/// Every fourth particle of the body has this material; the others are elastic.
double errorOfForces(const Material& m, bool freezing) {
  const auto points = lattice({4, 3, 3}, 0.1, 0.2);
  BodyOptions options;
  options.freezing = freezing;
  options.material = [](std::size_t i) { return i % 4 == 1; };
  const auto b = makeBody(points, {m, elasticMaterial(3e4, 0.2)}, options);
  std::vector<Vec3d> moved;
  for (std::size_t s = 0; s < points.size(); s++) moved.push_back(points[s] + 0.012 * noise3(s, 3));
  moveAll(*b, moved, [](const Vec3d& x) { return x; });
  computeForces(*b);
  const std::vector<Vec3d> force(b->solids.force.data(), b->solids.force.data() + points.size());
  double scale = 0, error = 0;
  for (const Vec3d& f : force) scale = std::max(scale, length(f));
  for (const std::size_t s : {0, 7, 13, 22, 35})
    for (int a = 0; a < 3; a++) {
      const double d = 1e-6;
      double energy[2];
      for (int side = 0; side < 2; side++) {
        b->solids.position[s] = moved[s];
        b->solids.position[s][a] += side == 0 ? -d : d;
        computeForces(*b);
        energy[side] = totalEnergy(*b);
      }
      b->solids.position[s] = moved[s];
      error = std::max(error, std::abs((energy[0] - energy[1]) / (2 * d) - force[s][a]));
    }
  return error / scale;
}

TEST(Laws, ForcesAreDerivativesOfTotalEnergy) {
  for (const std::string& law : allLaws())
    for (const bool freezing : {false, true}) {
      Material m = materialOf(law, 1e4);
      m.volumeStiffness = 5e3;
      m.hourglass = 0.8;
      EXPECT_LT(errorOfForces(m, freezing), 2e-7) << law << ' ' << freezing;
      // Hourglass control yields at a mean error of 0.05; the deformation itself does not.
      m.yieldStrain = {1, 1};
      m.hourglass = 20;
      EXPECT_LT(errorOfForces(m, freezing), 2e-7) << law << ' ' << freezing << ", limited hourglass control";
    }
}

TEST(Laws, HourglassStressStaysBelowYieldStress) {
  Material m = materialOf("neo-hookean", 1e4);
  m.yieldStrain = {0.01, 0.01};
  const ElasticConstants c = elasticConstants(m, 0);
  const double yield = std::sqrt(6.0) * c.mu * 0.01;
  for (const double error : {0.001, 0.01, 0.1, 1.0}) {
    const double d = 1e-6 * error, stress = (hourglassEnergy(c, std::pow(error + d, 2)) -
                                             hourglassEnergy(c, std::pow(error - d, 2))) /
                                            (2 * d);
    EXPECT_NEAR(stress, std::min(m.hourglass * 1e4 * error, yield), 1e-6 * yield) << error;
  }
  m.creepRate = {10, 10};  // the stress of a creeping solid may exceed the yield stress
  EXPECT_EQ(elasticConstants(m, 0).hourglassYield, never);
}
