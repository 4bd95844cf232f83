// SPDX-License-Identifier: Apache-2.0
// An unknown key is the only message of its table: checks that assume known keys could only repeat it.
#include <gtest/gtest.h>

#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

const std::string start = R"(spacing = "2 cm"
[domain]
max = [1, 1, 1]
)";
const std::string body = R"([[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
material = "wax"
)";

std::vector<std::string> errorsOf(const std::string& text) {
  try {
    readScene(sceneFilesOf("s.toml", text));
  } catch (const SceneErrors& e) { return e.lines; }
  return {};
}

/// Expects one message, with this text.
void expectOnly(const std::string& text, const std::string& message) {
  const std::vector<std::string> lines = errorsOf(text);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.size(), 1u) << lines.back();
  EXPECT_NE(lines[0].find(message), std::string::npos) << lines[0];
}

TEST(FollowOnErrors, UnknownKeyOfAMaterialHidesItsChecks) {
  expectOnly(start + "[material.wax]\nyuong = 1e5\nmelts = 330\n" + body,
             "unknown key 'yuong' in material.wax; did you mean 'young'?");
}

TEST(FollowOnErrors, UnknownKeyHidesTheMissingOne) {
  expectOnly(start + "[material.wax]\nviscosity = 1\n" + body + "[[lamp]]\npwoer = 3\nposition = [0, 0, 1]\n",
             "unknown key 'pwoer' in lamp.0; did you mean 'power'?");
  expectOnly(start + "[material.wax]\nviscosity = 1\n[[body]]\nbox = {}\nmaterials = 'wax'\n",
             "unknown key 'materials' in body.0; did you mean 'material'?");
}

TEST(FollowOnErrors, UnknownKeyHidesMissingShapes) {
  expectOnly(start + "[material.wax]\nviscosity = 1\n[[body]]\nshpere = { radius = 0.1 }\nmaterial = 'wax'\n",
             "unknown key 'shpere' in body.0; did you mean 'sphere'?");
}

TEST(FollowOnErrors, UnknownKeyOfNumericsHidesChecksOfItsOtherKeys) {
  expectOnly(start + "[numerics]\ndensity = 'summation'\ntensile_limit = 0.5\nshfting = 0.1\n" +
                 "[material.wax]\nviscosity = 1\n" + body,
             "unknown key 'shfting' in numerics; did you mean 'shifting'?");
}

TEST(FollowOnErrors, UnknownTableHidesMissingNames) {
  expectOnly(start + "[materials.wax]\nviscosity = 1\n" + body,
             "unknown key 'materials'; did you mean 'material'?");
}

TEST(FollowOnErrors, AnUnknownTableOfAnotherKindKeepsMissingNames) {
  const std::vector<std::string> lines = errorsOf(start + "[outpt]\n" + body);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("unknown key 'outpt'; did you mean 'output'?"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("unknown material 'wax'"), std::string::npos) << lines[1];
  expectOnly(start + "[xyz]\n" + body, "unknown key 'xyz'");
}

TEST(FollowOnErrors, OtherTablesAndValuesAreStillReported) {
  const std::vector<std::string> lines = errorsOf(start + "[material.wax]\nyuong = 1e5\nviscosity = -1\n" +
                                                  body + "[[emitter]]\nmaterial = 'oil'\n");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NE(lines[0].find("unknown key 'yuong'"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("viscosity: must be >= 0"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("unknown material 'oil'"), std::string::npos) << lines[2];
}

TEST(FollowOnErrors, ChecksAreReportedWithoutUnknownKeys) {
  expectOnly(start + "[material.wax]\nviscosity = 1\nmelts = 330\nheat_capacity = 1000\n" + body,
             "a material that melts is a solid below its melting temperature");
}

TEST(FollowOnErrors, AnUnknownExtensionHasNoUnknownKeys) {
  expectOnly(start + "[material.wax]\nviscosity = 1\n[extension.lamp]\npower = 1\n" + body,
             "extension.lamp: unknown extension");
}

TEST(OtherNames, AreRefusedWithTheNameOfTheTable) {
  const std::string wax = start + "[material.wax]\nviscosity = 1\n" + body;
  expectOnly(wax + "[[tempering]]\ntemperature = 300\n", "tempering: unknown table: expected [[thermostat]]");
  expectOnly(wax + "[[wall]]\nplane = {}\n", "wall: unknown table: expected [[obstacle]]");
}

}  // namespace
}  // namespace thaw
