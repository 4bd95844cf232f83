// SPDX-License-Identifier: Apache-2.0
// Messages of the reader for wrong scenes: each with its place, all of a file at once.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

/// A valid scene; cases replace parts of it.
const std::string good = R"(spacing = "2 cm"
end = "1 s"
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.jelly]
young = "20 kPa"
[[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
material = "jelly"
[[obstacle]]
name = "floor"
plane = { point = [0, 0, -0.5], normal = [0, 0, 1] }
)";

std::string with(const std::string& what, const std::string& by) {
  std::string s = good;
  const std::size_t at = s.find(what);
  EXPECT_NE(at, s.npos) << what;
  return s.replace(at, what.size(), by);
}

std::vector<std::string> errorsOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    readScene(sceneFilesOf("s.toml", text), overrides);
  } catch (const SceneErrors& e) { return e.lines; }
  return {};
}

void expectOnly(const std::vector<std::string>& lines, const std::string& line) {
  ASSERT_EQ(lines.size(), 1u) << line << "\n"
                              << (lines.empty() ? "no error" : lines[0] + "\n" + lines.back());
  EXPECT_EQ(lines[0], line);
}

TEST(BadScene, ValidSceneIsAccepted) {
  const Scene s = readScene(sceneFilesOf("s.toml", good));
  EXPECT_EQ(s.spacing, 0.02);
  EXPECT_EQ(s.bodies.size(), 1u);
  EXPECT_EQ(s.materials[0].young.solid, 2e4);
}

TEST(BadScene, EveryErrorHasAMessageWithItsPlace) {
  const struct {
    const char *what, *by, *line;
  } table[] = {
      {"spacing", "spacng", "s.toml:1:1: error: unknown key 'spacng'; did you mean 'spacing'?"},
      {"young", "yuong", "s.toml:7:1: error: unknown key 'yuong' in material.jelly; did you mean 'young'?"},
      {"\"2 cm\"", "true", "s.toml:1:11: error: spacing: expected a length such as \"2 mm\", got true"},
      {"\"2 cm\"", "[1]", "s.toml:1:11: error: spacing: expected a length such as \"2 mm\", got a list"},
      {"\"2 cm\"", "\"2 kg\"",
       "s.toml:1:11: error: spacing: expected a length such as \"2 mm\", got \"2 kg\""},
      {"\"2 cm\"", "\"2 cmm\"",
       "s.toml:1:11: error: spacing: expected a length such as \"2 mm\", got \"2 cmm\" (unknown unit 'cmm')"},
      {"\"2 cm\"", "\"\"", "s.toml:1:11: error: spacing: expected a length such as \"2 mm\", got \"\""},
      {"\"2 cm\"", "-0.02", "s.toml:1:11: error: spacing: must be > 0 m, got -0.02"},
      {"\"2 cm\"", "0", "s.toml:1:11: error: spacing: must be > 0 m, got 0"},
      {"\"2 cm\"", "nan", "s.toml:1:11: error: spacing: must be a finite number, got nan"},
      {"\"2 cm\"", "-inf", "s.toml:1:11: error: spacing: must be a finite number, got -inf"},
      {"\"2 cm\"", "\"inf m\"", "s.toml:1:11: error: spacing: must be a finite number, got \"inf m\""},
      {"\"1 s\"", "-1", "s.toml:2:7: error: end: must be >= 0 s, got -1"},
      {"\"20 kPa\"", "\"20 kPa\"\npoisson = 0.5",
       "s.toml:8:11: error: material.jelly.poisson: must be > -1 and < 0.5, got 0.5"},
      {"\"20 kPa\"", "\"20 kPa\"\ndensity = 0",
       "s.toml:8:11: error: material.jelly.density: must be > 0 kg/m^3, got 0"},
      {"\"20 kPa\"", "\"20 kPa\"\nlaw = \"hooke\"",
       "s.toml:8:7: error: material.jelly.law: expected one of \"green\", \"neo-hookean\", \"corotated\", "
       "\"rigid\", got \"hooke\""},
      {"name = \"block\"", "temperature = \"-300 degC\"\nname = \"block\"",
       "s.toml:9:15: error: body.block.temperature: must be > 0 K, got \"-300 degC\""},
      {"material = \"jelly\"", "material = \"jely\"",
       "s.toml:11:12: error: body 'block': unknown material 'jely'; did you mean 'jelly'?"},
      {"material = \"jelly\"\n", "",
       "s.toml:8:1: error: body 'block': its material is missing: expected `material`"},
      {"[0.1, 0.1, 0.1]", "[0.1, 0.1]",
       "s.toml:10:16: error: body.block.box.size: expected a list of three quantities such as [0, 0, 0], got "
       "a list of 2"},
      {"[0.1, 0.1, 0.1]", "[0.1, 0.1, -0.1]",
       "s.toml:10:16: error: body.block.box.size: edge lengths must be > 0 m"},
      {"[1, 1, 1]", "[1, 1, -1]", "s.toml:5:7: error: domain.max: must exceed `domain.min` along z"},
      {"[1, 1, 1]", "[-1, 1, -1]", "s.toml:5:7: error: domain.max: must exceed `domain.min` along x, z"},
      {"min = [-1, -1, -1]\nmax = [1, 1, 1]", "min = [1, 0, 0]",
       "s.toml:4:7: error: domain.min: must be below `domain.max` along x"},
      {"normal = [0, 0, 1]", "normal = [0, 0, 0]",
       "s.toml:14:42: error: obstacle.floor.plane.normal: must not be zero: expected a direction"}};
  for (const auto& t : table) expectOnly(errorsOf(with(t.what, t.by)), t.line);
}

TEST(BadScene, DuplicateNamesAreErrors) {
  const std::string again = "[[body]]\nname = \"block\"\nbox = {}\nmaterial = \"jelly\"\n";
  expectOnly(errorsOf(good + again), "s.toml:15:1: error: duplicate body name 'block'; first used in line 8");
  const std::vector<std::string> twice = errorsOf("spacing = 1\n" + good);
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_EQ(twice[0].rfind("s.toml:2:11: error: ", 0), 0u) << twice[0];
}

TEST(BadScene, ConflictsOfNumericsHaveThePlaceOfTheirKey) {
  const auto only = [](const std::string& keys) {
    const std::vector<std::string> lines = errorsOf(good + "[numerics]\n" + keys);
    return lines.size() == 1 ? lines[0] : std::to_string(lines.size()) + " errors";
  };
  EXPECT_EQ(only("tensile_limit = 0.5\nshifting = 0\n")
                .rfind("s.toml:16:17: error: `numerics.tensile_limit` above 0 needs `numerics.shifting`", 0),
            0u);
  EXPECT_EQ(
      only("density = \"continuity\"\npressure_solver = \"incompressible\"\n")
          .rfind("s.toml:16:11: error: `numerics.density = \"continuity\"` needs the equation of state", 0),
      0u);
  EXPECT_EQ(only("elastic_substeps = 4\nsleep_speed = 0.1\n")
                .rfind("s.toml:17:15: error: `numerics.sleep_speed` cannot be combined", 0),
            0u);
  const std::string rigid = "s.toml:16:12: error: `numerics.rigidify` cannot be combined with `numerics.";
  EXPECT_EQ(only("rigidify = 0.1\nsleep_speed = 0.1\n").rfind(rigid + "sleep_speed", 0), 0u);
  EXPECT_EQ(only("rigidify = 0.1\nelastic_substeps = 2\n").rfind(rigid + "elastic_substeps", 0), 0u);
  EXPECT_EQ(only("rigidify = \"off\"\nsleep_speed = 0.1\n"), "0 errors");
  const std::string wrong =
      "s.toml:16:12: error: numerics.rigidify: expected a rate such as \"5 1/s\" or \"off\", got";
  EXPECT_EQ(only("rigidify = \"of\"\n").rfind(wrong, 0), 0u) << only("rigidify = \"of\"\n");
}

TEST(BadScene, WeldsOfRigidPiecesNeedARigidMaterialThatIsSolidThen) {
  const auto only = [](const std::string& keys) {
    const std::vector<std::string> lines = errorsOf(with("young = \"20 kPa\"", keys));
    return lines.size() == 1 ? lines[0] : std::to_string(lines.size()) + " errors";
  };
  EXPECT_EQ(only("law = \"rigid\"\nweld_temperature = 1000\nweld_time = 0.1"), "0 errors");
  EXPECT_EQ(only("young = 1e4\nweld_temperature = 1000"),
            "s.toml:8:20: error: material.jelly.weld_temperature: applies to rigid solids only "
            "(`law = \"rigid\"`); others weld with `weld = true`");
  EXPECT_EQ(
      only("law = \"rigid\"\nweld = true"),
      "s.toml:8:8: error: material.jelly.weld: has no effect with `law = \"rigid\"`: rigid pieces weld at "
      "`weld_temperature`; remove `weld`, or choose another law");
  EXPECT_EQ(
      only("law = \"rigid\"\nweld_time = 0.1"),
      "s.toml:8:13: error: material.jelly.weld_time: applies only with `weld_temperature`: set it, too");
  EXPECT_EQ(only("law = \"rigid\"\nheat_capacity = 450\nmelts = [900, 950]\nweld_temperature = 950"),
            "s.toml:10:20: error: material.jelly.weld_temperature: the material melts at 950 K, before its "
            "pieces weld: expected a lower temperature");
}

TEST(BadScene, AllErrorsAtOnceInTheirOrder) {
  std::string s = with("\"2 cm\"", "-1");
  s.replace(s.find("young"), 5, "yuong");
  s.replace(s.find("[1, 1, 1]"), 9, "nan");
  const std::vector<std::string> lines = errorsOf(s);
  ASSERT_GE(lines.size(), 3u);
  EXPECT_EQ(lines[0].rfind("s.toml:1:11: error: spacing", 0), 0u) << lines[0];
  EXPECT_EQ(lines[1].rfind("s.toml:5:7: error: domain.max", 0), 0u) << lines[1];
  EXPECT_EQ(lines.back(), "s.toml:7:1: error: unknown key 'yuong' in material.jelly; did you mean 'young'?");
}

TEST(BadScene, ErrorsOfOverridesNameThem) {
  expectOnly(errorsOf(good, {"spacng=3"}),
             "--set spacng=3: error: unknown key 'spacng'; did you mean 'spacing'?");
  expectOnly(errorsOf(good, {"spacing=-3"}), "--set spacing=-3: error: spacing: must be > 0 m, got -3");
  expectOnly(errorsOf(good, {"spacing=3 kg"}),
             "--set spacing=3 kg: error: spacing: expected a length such as \"2 mm\", got \"3 kg\"");
  for (const char* bad :
       {"spacing", "", "=3", ".=1", "a..b=1", "body=1", "body.block=3", "body.nobody.velocity=[0,0,0]",
        "spacing.x=1", "include=\"x\"", "material.jelly.young.x=1"})
    EXPECT_FALSE(errorsOf(good, {bad}).empty()) << bad;
  EXPECT_EQ(readScene(sceneFilesOf("s.toml", good), {"spacing=3 cm", "body.block.velocity=[0, 0, -1]"})
                .bodies[0]
                .velocity.z,
            -1);
}

TEST(BadScene, InvalidTextsAreErrors) {
  const auto starts = [](const std::string& text, const std::string& with) {
    const std::vector<std::string> lines = errorsOf(text);
    ASSERT_FALSE(lines.empty()) << with;
    EXPECT_EQ(lines[0].rfind(with, 0), 0u) << lines[0];
  };
  starts("", "s.toml: error: the file is empty");
  starts(std::string("a\0b", 3), "s.toml: error: has a zero byte");
  starts("x = " + std::string(20000, '1'), "s.toml: error: line 1 is longer than 16384");
  starts(std::string((16u << 20) + 1, '\n'), "s.toml: error: larger than 16 MiB");
  starts("\xff\xfe\x01\x02", "s.toml:1:1: error: ");
  starts("# nothing but this\n", "s.toml:1:1: error: there is nothing to simulate");
  for (std::size_t cut = 1; cut < good.size(); cut++) {  // a truncated file is an error, or a shorter scene
    try {
      readScene(sceneFilesOf("s.toml", good.substr(0, cut)));
    } catch (const SceneErrors& e) { EXPECT_FALSE(e.lines.empty()); }
  }
  EXPECT_FALSE(errorsOf(good.substr(0, good.find("material = "))).empty());
}

TEST(BadScene, ErrorsOfIncludesNameTheFile) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("thaw_bad_scene_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder / name) << text; };
  const auto said = [&](const char* name) {
    try {
      readScene((folder / name).string());
    } catch (const SceneErrors& e) { return std::string(e.what()); }
    return std::string();
  };
  write("self.toml", "include = \"self.toml\"\n");
  write("a.toml", "include = \"b.toml\"\n");
  write("b.toml", "include = [\"a.toml\"]\n");
  write("lost.toml", "include = \"nowhere.toml\"\n");
  write("number.toml", "include = 3\n");
  write("broken.toml", "include = \"part.toml\"\n");
  write("part.toml", "spacing = \n");
  write("whole.toml", "include = \"base.toml\"\nspacing = 0.01\n");
  write("base.toml", good);
  EXPECT_NE(said("self.toml").find("includes itself"), std::string::npos) << said("self.toml");
  EXPECT_NE(said("a.toml").find("includes itself"), std::string::npos) << said("a.toml");
  EXPECT_NE(said("lost.toml").find("lost.toml:1:11: error: include: '"), std::string::npos)
      << said("lost.toml");
  EXPECT_NE(said("lost.toml").find("no such file"), std::string::npos);
  EXPECT_NE(said("number.toml").find("expected a path or a list of paths"), std::string::npos);
  EXPECT_NE(said("broken.toml").find("part.toml:1:"), std::string::npos) << said("broken.toml");
  EXPECT_NE(said("missing.toml").find("no such file"), std::string::npos);
  EXPECT_EQ(said("whole.toml"), "");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace thaw
