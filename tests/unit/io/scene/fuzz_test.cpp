// SPDX-License-Identifier: Apache-2.0
// Damaged copies of scenes/melt.toml give a scene with valid values or a list of errors, and nothing else.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Applies a few changes: bytes, lines, truncation, and critical words. Uses only std::mt19937_64, which is
/// the same everywhere.
std::string damaged(std::string s, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random() % std::max<std::size_t>(1, n));
  };
  const char* const words[] = {"nan",
                               "-inf",
                               "1e999",
                               "-1",
                               "0",
                               "\"",
                               "'''",
                               "[[",
                               "]]",
                               "{",
                               "}",
                               "=",
                               "\n",
                               "\\u0000",
                               "\"5 parsec\"",
                               "never",
                               "1e-320",
                               "[",
                               "include = \"x\"",
                               "a.b.c",
                               "true",
                               "\xff",
                               "9223372036854775808"};
  for (std::size_t edits = 1 + below(3); edits > 0 && !s.empty(); edits--) {
    const std::size_t at = below(s.size());
    switch (below(7)) {
      case 0: s[at] = static_cast<char>(random()); break;
      case 1: s.erase(at, 1 + below(20)); break;
      case 2: s.insert(at, words[below(std::size(words))]); break;
      case 3: s.insert(at, s.substr(below(s.size()), below(60))); break;
      case 4: s.resize(at); break;
      case 5: {  // another value
        const std::size_t equals = s.find('=', at);
        if (equals == s.npos) break;
        s.replace(equals + 1, s.find('\n', equals) == s.npos ? s.npos : s.find('\n', equals) - equals - 1,
                  std::string(" ") + words[below(std::size(words))]);
        break;
      }
      default: std::swap(s[at], s[below(s.size())]);
    }
  }
  return s;
}

/// Checks the values of a scene after reading any file.
void expectSound(const Scene& s, const std::string& text) {
  bool good = std::isfinite(s.spacing) && s.spacing > 0 && std::isfinite(s.end) && s.end >= 0 &&
              s.output.every > 0 && (!s.bodies.empty() || !s.emitters.empty());
  for (int a = 0; a < 3; a++)
    good = good && s.domain.max[a] > s.domain.min[a] && std::isfinite(s.domain.gravity[a]);
  for (const Material& m : s.materials)
    good = good && m.density > 0 && std::isfinite(m.density) && m.young.solid >= 0 &&
           std::isfinite(m.young.solid) && m.poisson.solid < 0.5 && m.heatCapacity.solid > 0 && m.solidus > 0;
  for (const Body& b : s.bodies)
    good = good && b.temperature > 0 && std::isfinite(b.temperature) && b.material >= 0 &&
           b.material < static_cast<int>(s.materials.size()) && std::isfinite(dot(b.velocity, b.velocity));
  EXPECT_TRUE(good) << text;
}

TEST(SceneFuzz, DamagedScenesAreScenesOrListsOfErrors) {
  const std::string whole = textOf(THAW_SOURCE_DIR "/scenes/melt.toml");
  ASSERT_GT(whole.size(), 500u);
  std::mt19937_64 random(20050101);
  const auto start = std::chrono::steady_clock::now();
  int read = 0, rejected = 0;
  for (int k = 0; k < 4000 && std::chrono::steady_clock::now() - start < std::chrono::seconds(20); k++) {
    const std::string text = damaged(whole, random);
    try {
      expectSound(readScene(sceneFilesOf("melt.toml", text)), text);
      read++;
    } catch (const SceneErrors& e) {
      rejected++;
      EXPECT_FALSE(e.lines.empty()) << text;
      for (const std::string& line : e.lines) EXPECT_NE(line.find("error: "), std::string::npos) << line;
    } catch (const std::exception& e) {
      ADD_FAILURE() << "mutation " << k << ": " << e.what() << "\n" << text;
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(rejected, 1000);
}

TEST(SceneFuzz, DamagedOverridesAreValuesOrErrors) {
  const SceneFiles files = sceneFilesOf("melt.toml", textOf(THAW_SOURCE_DIR "/scenes/melt.toml"));
  std::mt19937_64 random(7);
  for (int k = 0; k < 1000; k++) {
    const char* const sound[] = {"spacing=\"2 mm\"", "body.bust.velocity=[0, 0, -1]",
                                 "material.wax.melts=[\"40 degC\", \"65 degC\"]",
                                 "obstacle.0.temperature=300"};
    const std::string setting = damaged(sound[random() % 4], random);
    try {
      const Scene s = readScene(files, {setting});
      expectSound(s, setting);
    } catch (const SceneErrors& e) { EXPECT_FALSE(e.lines.empty()); } catch (const std::exception& e) {
      ADD_FAILURE() << "--set " << setting << ": " << e.what();
    }
  }
}

}  // namespace
}  // namespace thaw
