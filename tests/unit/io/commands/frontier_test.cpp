// What `thaw check` says of the accuracy suite: with the scene's own keys, and only what it can use.
#include "io/commands/frontier.hpp"

#include <gtest/gtest.h>

#include "core/scene/modules.hpp"
#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

std::string linesOf(const std::string& rest) {
  SceneFiles files;
  files.main = "test.toml";
  files.texts["test.toml"] = "spacing = 0.1\nend = 1\n[material.steel]\nyoung = 1e5\n[material.water]\n" + rest;
  const Scene s = readScene(files);
  std::string all;
  for (const std::string& line : frontierLines(s, modulesOf(s))) all += line + "\n";
  return all;
}

std::string body(const std::string& name, const std::string& material, double x) {
  return "[[body]]\nname = '" + name + "'\nmaterial = '" + material + "'\nbox = { size = [0.3, 0.3, 0.3] }\nplace = { move = [" + std::to_string(x) + ", 0, 0] }\n";
}

}  // namespace

TEST(Frontier, NamesTheMaterialsOfTheScene) {
  const std::string text = linesOf(body("a", "steel", 0));
  EXPECT_NE(text.find("material.steel.hourglass="), std::string::npos) << text;
  EXPECT_EQ(text.find("rubber"), std::string::npos) << text;
  EXPECT_EQ(text.find('*'), std::string::npos) << text;
  EXPECT_EQ(text.find("martin_moyce"), std::string::npos) << text;
}

TEST(Frontier, KeysAreThoseThatSetTakes) {
  const std::string text = linesOf(body("a", "water", 0));
  EXPECT_NE(text.find("numerics.support="), std::string::npos) << text;
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    const std::size_t start = text.find_last_of(" '", at) + 1;
    const std::string key = text.substr(start, at - start);
    EXPECT_TRUE(key == "quality" || key.rfind("numerics.", 0) == 0 || key.rfind("material.", 0) == 0) << key;
  }
}

TEST(Frontier, SubstepsAreForSolidsThatCannotMeet) {
  const std::string water = body("w", "water", -0.6);
  EXPECT_NE(linesOf(water + body("a", "steel", 0)).find("elastic_substeps="), std::string::npos);
  EXPECT_EQ(linesOf(water + body("a", "steel", 0) + body("b", "steel", 0.6)).find("elastic_substeps="), std::string::npos);
}

}  // namespace thaw
