// SPDX-License-Identifier: Apache-2.0
// Fixed steps beyond the limits of the start are reported, with the limit.
#include <gtest/gtest.h>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

Scene cube() {
  Scene s;
  s.file = "cube.toml";
  s.spacing = 0.01;
  s.domain.side[2][0] = Side::Wall;
  s.materials.resize(1);
  s.materials[0].soundSpeed = 20;
  Body body;
  body.shape = boxOf({-0.03, -0.03, -0.5}, {0.03, 0.03, -0.44});
  s.bodies.push_back(body);
  s.output.every = 0.1;
  return s;
}

std::string stepWarning(const Scene& s) {
  const Simulation run(s);
  for (const SceneWarning& w : run.report.warnings)
    if (w.text.find("numerics.fixed_step") != std::string::npos) return w.where.file + ": " + w.text;
  return "";
}

}  // namespace

TEST(FixedStep, IsReportedWithTheLimitThatItExceeds) {
  Scene s = cube();
  EXPECT_EQ(stepWarning(s), "");
  s.numerics.fixedStep = 1e-3;  // sound: 0.4 * 2 * 0.01 m / (20 m/s) = 4e-4 s
  const std::string text = stepWarning(s);
  EXPECT_EQ(text.find("cube.toml: numerics.fixed_step: steps of 0.001 s are longer than the limit of sound, "
                      "0.0004 s: "),
            0u)
      << text;
  EXPECT_NE(text.find("to 0.000396 s or less"), std::string::npos) << text;
  s.numerics.fixedStep = 3.9e-4;
  EXPECT_EQ(stepWarning(s), "");
}

TEST(FixedStep, IsReportedWithAllLimitsThatItExceeds) {
  Scene s = cube();
  s.numerics.fixedStep = 1e-3;
  s.numerics.maxStep = 2e-4;
  EXPECT_NE(stepWarning(s).find("the limit of max_step, 0.0002 s (also sound, 0.0004 s): "),
            std::string::npos)
      << stepWarning(s);
}

TEST(FixedStep, IsComparedAfterItIsShortenedToFrames) {
  Scene s = cube();
  s.numerics.fixedStep = 1e-3;
  s.output.every = 3.9e-4;
  EXPECT_EQ(stepWarning(s), "");
}

}  // namespace thaw::test
