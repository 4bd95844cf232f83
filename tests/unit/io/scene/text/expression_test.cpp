// SPDX-License-Identifier: Apache-2.0
// Expressions of position in scene files: values, places of errors, restart records.
#include <gtest/gtest.h>

#include <clocale>
#include <numbers>

#include "io/run/restart/restart_record.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/text/expression.hpp"

namespace thaw {
namespace {

double valueOf(const std::string& text, const Vec3d& x) {
  const Expression e = parseExpression(text);
  EXPECT_EQ(e.error, "") << text;
  return e.error.empty() ? e.value(x) : NAN;
}

Scene sceneWith(const std::string& bodyKeys, const std::string& emitterKeys = "") {
  std::string text =
      "spacing = 0.1\n[material.water]\ndensity = 1000\n[[body]]\nname = 'drop'\nsphere = { radius = 0.4 "
      "}\nmaterial = 'water'\n" +
      bodyKeys;
  if (!emitterKeys.empty()) text += "\n[[emitter]]\nname = 'jet'\nmaterial = 'water'\n" + emitterKeys;
  return readScene(sceneFilesOf("test.toml", text));
}

std::string errorOf(const std::string& bodyKeys) {
  try {
    sceneWith(bodyKeys);
  } catch (const SceneErrors& e) { return e.what(); }
  return "";
}

}  // namespace

TEST(Expression, HasTheValuesOfItsFunctions) {
  EXPECT_EQ(valueOf("-100*x", {0.5, 0, 0}), -50);
  EXPECT_EQ(valueOf("300 + 20*z", {0, 0, 2}), 340);
  EXPECT_EQ(valueOf("-x^2", {3, 0, 0}), -9);
  EXPECT_EQ(valueOf("z > 1 ? 2 : y", {0, 7, 0}), 7);
  EXPECT_DOUBLE_EQ(valueOf("sin(pi*x) + exp(y) * sqrt(z)", {0.25, 1, 4}),
                   std::sin(std::numbers::pi * 0.25) + std::exp(1.0) * 2);
  EXPECT_TRUE(std::isinf(valueOf("1/x", {})));
}

TEST(Expression, ReadsDecimalPointsInAnyLocale) {
  const char* before = std::setlocale(LC_ALL, nullptr);
  const std::string kept = before ? before : "C";
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // has no effect if the locale is not installed
  EXPECT_EQ(valueOf("1.5*x", {2, 0, 0}), 3);
  std::setlocale(LC_ALL, kept.c_str());
}

TEST(Expression, ErrorsNameTheProblemAndThePlace) {
  EXPECT_EQ(parseExpression("20*q").error, "unknown name \"q\" at character 4");
  EXPECT_EQ(parseExpression("20*pq ").error, "unknown name \"pq\" at character 4");
  EXPECT_EQ(parseExpression(std::string("x\0+ nonsense", 12)).error, "character 2 is a zero byte");
  EXPECT_EQ(parseExpression("20*").error, "it ends too early");
  EXPECT_NE(parseExpression("(x").error, "");
  EXPECT_NE(parseExpression("x, y").error, "");
  EXPECT_NE(parseExpression("").error, "");
  EXPECT_NE(parseExpression("\"a\"").error, "");
  EXPECT_EQ(parseExpression("x = 3").error,
            "'=' at character 3: nothing can be assigned here (equality is '==')");
  EXPECT_NE(parseExpression(std::string(2000, '(')).error, "");
}

TEST(Expression, IsDistinguishedFromAQuantity) {
  for (const char* quantity : {"20 degC", "300 K", "300", "2e3", "20 degX", "5 m/s", "-2e-3", "4 1/s"})
    EXPECT_FALSE(looksLikeExpression(quantity)) << quantity;
  for (const char* expression : {"z", "300 + 20*z", "2*q", "sin(", "-x", "1/0", "2 / 3", "3-2"})
    EXPECT_TRUE(looksLikeExpression(expression)) << expression;
}

TEST(SceneFields, AreReadFromTablesAndTexts) {
  const Body b = sceneWith(
                     "velocity = { x = '-100*x', z = '5 m/s' }\ntemperature = '300 + "
                     "20*z'\nvelocity_gradient = [[1, 2, 3], [0, 0, 0], [0, 0, '4 1/s']]\n")
                     .bodies[0];
  ASSERT_TRUE(b.velocityField.component[0]);
  EXPECT_EQ(b.velocityField.component[0].value({2, 0, 0}), -200);
  EXPECT_EQ(b.velocityField.component[0].key, "body.drop.velocity.x");
  EXPECT_FALSE(b.velocityField.component[1]);
  EXPECT_FALSE(b.velocityField.component[2]);
  EXPECT_EQ(b.velocity.z, 5);
  EXPECT_EQ(b.temperatureField.value({0, 0, 1}), 320);
  EXPECT_TRUE(b.velocityField.linear);
  EXPECT_EQ(b.velocityField.gradient.row[0].z, 3);
  EXPECT_EQ(b.velocityField.gradient.row[2].z, 4);
  const Emitter e = sceneWith("", "velocity = { x = '-5*y', y = 1 }\ntemperature = '300 + x'\n").emitters[0];
  EXPECT_EQ(e.velocityField.component[0].value({0, 2, 0}), -10);
  EXPECT_EQ(e.velocityField.component[1].value({0, 2, 0}), 1);
  EXPECT_EQ(e.temperatureField.value({1, 0, 0}), 301);
}

TEST(SceneFields, ErrorsAreOneMessageWithItsPlace) {
  EXPECT_EQ(errorOf("velocity = { x = '20*q' }\n"),
            "test.toml:8:18: error: body.drop.velocity.x: expected an expression of x, y and z (m, without "
            "units; its value is in m/s), got \"20*q\": unknown name \"q\" at character 4");
  EXPECT_NE(errorOf("velocity = { w = 'x' }\n")
                .find("test.toml:8:14: error: unknown key 'w' in body.drop.velocity"),
            std::string::npos)
      << errorOf("velocity = { w = 'x' }\n");
  EXPECT_NE(errorOf("temperature = '300 + '\n")
                .find("test.toml:8:15: error: body.drop.temperature: expected an expression"),
            std::string::npos);
  EXPECT_NE(errorOf("temperature = '20 degX'\n").find("expected a temperature such as"), std::string::npos);
  EXPECT_NE(
      errorOf("velocity_gradient = [1, 2, 3]\n")
          .find(
              "test.toml:8:21: error: body.drop.velocity_gradient: expected three lists of three quantities"),
      std::string::npos)
      << errorOf("velocity_gradient = [1, 2, 3]\n");
  EXPECT_NE(
      errorOf("velocity_gradient = [[1, 2, 3], [1, 2], [1, 2, 3]]\n").find("got a list of 2 in place 2"),
      std::string::npos);
}

TEST(SceneFields, ArePartOfTheRestartRecord) {
  const Scene a = sceneWith("velocity = { x = '-100*x' }\n",
                            "temperature = '300 + x'\nvelocity = { x = 'y' }\n");
  const Scene b = sceneWith("velocity = { x = '-200*x' }\n",
                            "temperature = '301 + x'\nvelocity = { x = '2*y' }\n");
  EXPECT_TRUE(initialStateChanges(restartRecordOf(a), a).empty());
  const auto start = initialStateChanges(restartRecordOf(a), b);
  EXPECT_EQ(start, std::vector<std::string>{"body.drop.velocity: [\"-100*x\", 0, 0] -> "
                                            "[\"-200*x\", 0, 0] m/s"});
  EXPECT_EQ(settingChanges(restartRecordOf(a), b, 0).size(), 1u);
  EXPECT_EQ(restartConflicts(restartRecordOf(a), b).size(), 1u);
  EXPECT_TRUE(restartConflicts(restartRecordOf(a), a).empty());
}

TEST(SceneFields, SurviveTheTextOfTheScene) {
  const Scene s = sceneWith("velocity = { x = '-100*x' }\ntemperature = '300 + 20*z'\n");
  const Scene again = readScene(sceneFilesOf("test.toml", s.text));
  EXPECT_EQ(again.bodies[0].velocityField.component[0].text, "-100*x");
  EXPECT_EQ(again.bodies[0].temperatureField.text, "300 + 20*z");
}

}  // namespace thaw
