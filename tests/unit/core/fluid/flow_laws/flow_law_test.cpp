// SPDX-License-Identifier: Apache-2.0
// Flow laws: stress by shear rate, regularisation, temperature.
#include <gtest/gtest.h>

#include <cmath>

#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/fluid/flow_laws/laws.hpp"

namespace thaw::test {
namespace {

constexpr double least = 1e-3;

double stressAt(const FlowLawSettings& s, double rate, double T = 300) {
  return apparentViscosity(flowCoefficients(s, least, T), rate) * rate;
}

FlowLawSettings settings(FlowLaw law, double yield, double viscosity, double n) {
  FlowLawSettings s;
  s.law = law;
  if (yield > 0) s.yieldStress = {{0, yield}};
  s.consistency = {{0, viscosity}};
  s.exponent = n;
  return s;
}

}  // namespace

TEST(FlowLaw, BinghamHasItsYieldStressAndPlasticViscosity) {
  const FlowLawSettings s = settings(FlowLaw::Bingham, 50, 2, 1);
  for (const double rate : {0.01, 0.1, 1.0, 100.0})
    EXPECT_NEAR(stressAt(s, rate), 50 + 2 * rate, 50 * std::exp(-rate / least) + 1e-12 * rate);
}

TEST(FlowLaw, HerschelBulkleyAndPowerLawFollowThePowerOfTheRate) {
  for (const double n : {0.5, 1.5})
    for (const double yield : {0.0, 50.0}) {
      const FlowLawSettings s = settings(yield > 0 ? FlowLaw::HerschelBulkley : FlowLaw::PowerLaw, yield, 2,
                                         n);
      for (const double rate : {0.1, 1.0, 100.0})
        EXPECT_NEAR(stressAt(s, rate) / (yield + 2 * std::pow(rate, n)), 1, std::pow(least / rate, 2));
    }
}

TEST(FlowLaw, CarreauFallsFromItsViscosityAtRest) {
  FlowLawSettings s = settings(FlowLaw::Carreau, 0, 56, 0.357);  // blood, in mPa s
  s.infiniteViscosity = 3.45, s.relaxationTime = 3.313;
  const FlowCoefficients c = flowCoefficients(s, least, 300);
  EXPECT_DOUBLE_EQ(apparentViscosity(c, 0), 56);
  EXPECT_NEAR(apparentViscosity(c, 1 / 3.313), 3.45 + 52.55 * std::pow(2, (0.357 - 1) / 2), 1e-12);
  EXPECT_NEAR(apparentViscosity(c, 1e9), 3.45, 1e-3);
}

TEST(FlowLaw, StressGrowsWithTheRate) {
  for (const double n : {0.1, 0.5, 1.0, 1.5, 3.0}) {
    const FlowLawSettings s = settings(FlowLaw::HerschelBulkley, 10, 2, n);
    double last = 0;
    for (double rate = 1e-8; rate < 1e4; rate *= 1.3) {
      const double stress = stressAt(s, rate);
      EXPECT_GT(stress, last) << n << " at " << rate;
      last = stress;
    }
  }
}

TEST(FlowLaw, ViscosityAtRestIsBounded) {
  FlowLawSettings s = settings(FlowLaw::HerschelBulkley, 50, 2, 0.5);
  const double rest = apparentViscosity(flowCoefficients(s, least, 300), 0);
  EXPECT_NEAR(rest, 50 / least + 2 / std::sqrt(least), 1e-9 * rest);
  EXPECT_DOUBLE_EQ(largestFlowViscosity(s, least, 100), rest);
  EXPECT_NEAR(leastFlowViscosity(s, least, 100), 0.7, 1e-6);
  s.largestViscosity = 1000;
  EXPECT_DOUBLE_EQ(apparentViscosity(flowCoefficients(s, least, 300), 0), 1000);
}

TEST(FlowLaw, LawsOfTheTableAreFiniteAtRestAndMonotonic) {
  for (const FlowLawRow* row : flowLawTable)
    for (const double n : {0.5, 1.0, 2.0}) {
      FlowLawSettings s = settings(row->law, 50, 2, n);
      s.infiniteViscosity = 0.5, s.relaxationTime = 3;
      const FlowCoefficients c = flowCoefficients(s, least, 300);
      EXPECT_GE(steepnessOf(s), 1) << row->name;
      EXPECT_TRUE(std::isfinite(apparentViscosity(c, 0))) << row->name;
      for (double rate = 1e-6; rate < 1e4; rate *= 1.3) {
        const double slope = std::log(stressAt(s, 1.01 * rate) / stressAt(s, rate)) / std::log(1.01);
        EXPECT_GT(slope, 0) << row->name << " at " << rate;
        EXPECT_LT(slope, steepnessOf(s) + 1e-6) << row->name << " at " << rate;
      }
    }
}

TEST(FlowLaw, ParametersFollowTheTemperature) {
  FlowLawSettings s = settings(FlowLaw::Bingham, 0, 0, 1);
  s.yieldStress = {{300, 100}, {400, 0}};
  s.consistency = {{300, 1000}, {400, 10}};
  const auto at = [&](double T) { return flowCoefficients(s, least, T); };
  EXPECT_DOUBLE_EQ(at(200).yieldStress, 100);
  EXPECT_DOUBLE_EQ(at(325).yieldStress, 75);
  EXPECT_DOUBLE_EQ(at(500).yieldStress, 0);
  EXPECT_DOUBLE_EQ(at(200).viscosity, 1000);
  EXPECT_NEAR(at(350).viscosity, 100, 1e-9);
  EXPECT_DOUBLE_EQ(at(500).viscosity, 10);
  EXPECT_DOUBLE_EQ(largestFlowViscosity(s, least, 1), 100 / least + 1000);
  EXPECT_DOUBLE_EQ(leastFlowViscosity(s, least, 1), 10);
}

TEST(FlowLaw, LeastRateFollowsTheExpectedSpeed) {
  Scene s;
  s.domain.min = {0, 0, 0}, s.domain.max = {2, 4, 1};
  s.bodies.emplace_back();
  s.domain.gravity = {};
  s.bodies[0].velocity = {0, 3, 0};
  Material m;
  EXPECT_DOUBLE_EQ(leastRateOf(s, m), 1e-4 * 3 / 4);
  m.flowLaw.leastRate = 0.2;
  EXPECT_DOUBLE_EQ(leastRateOf(s, m), 0.2);
}

}  // namespace thaw::test
