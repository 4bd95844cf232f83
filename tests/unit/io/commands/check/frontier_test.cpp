// SPDX-License-Identifier: Apache-2.0
// Figures of the accuracy suite in `thaw check`: with the scene's own keys, and only applicable settings.
#include "io/commands/check/frontier.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/terms/find_modules.hpp"
#include "io/commands/check/frontier_file.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

std::string textOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::vector<FrontierPoint>& points() {
  static const std::vector<FrontierPoint> all = parseFrontier(
      "frontier.csv", textOf(THAW_SOURCE_DIR "/docs/accuracy/frontier.csv"));
  return all;
}

std::string linesOf(const std::string& rest) {
  SceneFiles files;
  files.main = "test.toml";
  files.texts["test.toml"] = "spacing = 0.1\nend = 1\n[material.steel]\nyoung = 1e5\n[material.water]\n" +
                             rest;
  const Scene s = readScene(files);
  std::string all;
  for (const std::string& line : frontierLines(points(), s, modulesOf(s))) all += line + "\n";
  return all;
}

std::string body(const std::string& name, const std::string& material, double x) {
  return "[[body]]\nname = '" + name + "'\nmaterial = '" + material +
         "'\nbox = { size = [0.3, 0.3, 0.3] }\nplace = { move = [" + std::to_string(x) + ", 0, 0] }\n";
}

}  // namespace

TEST(Frontier, NamesTheMaterialsOfTheScene) {
  const std::string text = linesOf(body("a", "steel", 0));
  EXPECT_NE(text.find("material.steel.hourglass="), std::string::npos) << text;
  EXPECT_EQ(text.find("rubber"), std::string::npos) << text;
  EXPECT_EQ(text.find('*'), std::string::npos) << text;
  EXPECT_EQ(text.find("martin_moyce"), std::string::npos) << text;
}

TEST(Frontier, KeysHaveTheFormOfSet) {
  const std::string text = linesOf(body("a", "water", 0)) + linesOf(body("a", "steel", 0));
  EXPECT_NE(text.find("numerics."), std::string::npos) << text;
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    const std::size_t start = text.find_last_of(" '", at) + 1;
    const std::string key = text.substr(start, at - start);
    EXPECT_TRUE(key == "quality" || key.rfind("numerics.", 0) == 0 || key.rfind("material.", 0) == 0) << key;
  }
  // the packing is a lattice already
  EXPECT_EQ(linesOf(body("a", "water", 0) + "[material.oil]\nsurface_tension = 0.03\n").find("packing"),
            std::string::npos);
  const std::string drop = linesOf(body("a", "water", 0) + "packing = 'relaxed'\n");
  EXPECT_EQ(drop.find("numerics.body"), std::string::npos) << drop;
}

TEST(Frontier, AdviceIsShortAndKeepsExplicitChoices) {
  const auto adviceOf = [](const std::string& rest) {
    const Scene s = readScene(
        sceneFilesOf("test.toml", "spacing = 0.1\nend = 1\n[material.steel]\nyoung = 1e5\n" + rest));
    std::vector<std::string> lines;
    for (const Suggestion& one : frontierAdvice(points(), s, modulesOf(s))) lines.push_back(one.line);
    return lines;
  };
  const std::string solid = body("a", "steel", 0);
  const std::vector<std::string> lines = adviceOf(solid);
  ASSERT_GE(lines.size(), 2u);
  EXPECT_LE(lines.size(), 8u);
  std::string all;
  for (const std::string& line : lines) {
    EXPECT_LE(line.size(), 160u) << line;
    EXPECT_TRUE(line.rfind("more accurate: --set ", 0) == 0 || line.rfind("faster:        --set ", 0) == 0)
        << line;
    all += line + "\n";
  }
  EXPECT_NE(
      all.find("faster:        --set numerics.cfl_elastic=0.6 (solids: the same error, 0.69 of the time)"),
      std::string::npos)
      << all;
  for (const std::string& line : adviceOf(solid + "[numerics]\ncfl_elastic = 0.5\n"))
    EXPECT_EQ(line.find("cfl_elastic"), std::string::npos) << line;
}

TEST(Frontier, AdviceComesFromSimilarCases) {
  const auto adviceOf = [](const std::string& domain, const std::string& liquid) {
    const Scene s = readScene(sceneFilesOf(
        "test.toml", "spacing = 0.1\nend = 1\n[domain]\nmin = [0, 0, 0]\nmax = [2, 2, 2]\n" + domain +
                         "\n[material.water]\n[[body]]\nmaterial = 'water'\n" + liquid));
    std::string all;
    for (const Suggestion& each : frontierAdvice(points(), s, modulesOf(s))) all += each.line + "\n";
    return all;
  };
  const auto has = [](const std::string& text, const char* what) {
    return text.find(what) != std::string::npos;
  };
  const std::string walls = "sides = { x = 'wall', y = 'periodic', z = 'wall' }",
                    tank = "box = { size = [2, 2, 1] }\nplace = { move = [1, 1, 0.5] }\n";
  const std::string dam = "box = { size = [1, 2, 1] }\nplace = { move = [0.5, 1, 0.5] }\n";
  EXPECT_FALSE(has(adviceOf(walls, dam), "liquid at rest"));
  EXPECT_FALSE(has(adviceOf(walls, tank + "velocity = [50, 0, 0]\n"), "numerics.density"));
  EXPECT_FALSE(has(adviceOf(walls, tank + "spin = [0, 0, 50]\n"), "numerics.density"));
  EXPECT_FALSE(
      has(adviceOf(walls + "\ngravity = [0, 0, 0]", tank + "velocity = [1, 0, 0]\n"), "numerics.density"));
  EXPECT_FALSE(has(adviceOf(walls + "\ngravity = [0, 0, 0]", dam), "liquid that falls"));
}

TEST(Frontier, KeepsThePackingOfTheScene) {
  const std::string scene =
      "spacing = 0.1\nend = 1\n[domain]\ngravity = [0, 0, 0]\n[material.water]\nsurface_tension = 0.07\n" +
      body("a", "water", 0) + "packing = 'relaxed'\n";
  const Scene s = readScene(sceneFilesOf("test.toml", scene));
  for (const Suggestion& one : frontierAdvice(points(), s, modulesOf(s)))
    EXPECT_EQ(one.line.find("packing"), std::string::npos) << one.line;
}

TEST(Frontier, SubstepsAreForSolidsWithoutContact) {
  const std::string water = body("w", "water", -0.6);
  EXPECT_NE(linesOf(water + body("a", "steel", 0)).find("elastic_substeps="), std::string::npos);
  EXPECT_EQ(linesOf(water + body("a", "steel", 0) + body("b", "steel", 0.6)).find("elastic_substeps="),
            std::string::npos);
}

// Only pieces of a single body that froze can touch, which limits few steps.
TEST(Frontier, SubstepsAreForABodyThatMelts) {
  const std::string wax =
      "[material.wax]\nyoung = 1e5\nconductivity = 1\nmelts = [310, 320]\n"
      "heat_capacity = 2000\nlatent_heat = 1e4\n"
      "[[obstacle]]\nname = 'plate'\nplane = { normal = [0, 0, 1] }\n"
      "temperature = 400\n";
  EXPECT_NE(linesOf(wax + body("a", "wax", 0)).find("elastic_substeps="), std::string::npos);
  EXPECT_EQ(linesOf(wax + body("a", "wax", 0) + body("b", "wax", 0.6)).find("elastic_substeps="),
            std::string::npos);
}

TEST(Frontier, TheFileOfTheBuildIsThatOfTheTree) {
  ASSERT_FALSE(frontierFile().empty());
  EXPECT_EQ(textOf(frontierFile()), textOf(THAW_SOURCE_DIR "/docs/accuracy/frontier.csv"));
  EXPECT_GT(points().size(), 90u);
}

TEST(Frontier, BadFilesAreRefusedWithTheLine) {
  const std::string header = "case,norm,settings,error,time,best\n", good = "a,L2,quality=preview,0.1,1,1\n";
  EXPECT_EQ(parseFrontier("f.csv", header + good).size(), 1u);
  EXPECT_TRUE(frontierLines({}, {}, {}).empty());
  for (const char* bad :
       {"a,L2,quality=preview,0.1,1", "a,L2,quality=preview,0.1,1,2", "a,L2,quality,0.1,1,1",
        "a,L2,quality=preview,,1,1", "a,L2,quality=preview,0.1,1x,1", ""})
    try {
      parseFrontier("f.csv", header + good + bad + "\n");
      ADD_FAILURE() << bad;
    } catch (const IoError& e) {
      EXPECT_EQ(std::string(e.what()).rfind("f.csv:3: expected the fields case,norm", 0), 0u) << e.what();
    }
  EXPECT_THROW(parseFrontier("f.csv", good), IoError);
}

}  // namespace thaw
