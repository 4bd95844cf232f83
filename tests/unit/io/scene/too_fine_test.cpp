// SPDX-License-Identifier: Apache-2.0
// Spacings that exceed any machine's memory give one message with the number of particles, at the line that
// sets them.
#include <gtest/gtest.h>

#include "io/scene/read_scene.hpp"
#include "io/scene/scene_files.hpp"

namespace thaw {
namespace {

const std::string around =
    "end = 1\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n[material.j]\nyoung = \"20 kPa\"\n";

std::string errorOf(const std::string& text) {
  try {
    readScene(sceneFilesOf("s.toml", text));
  } catch (const SceneErrors& e) { return e.what(); }
  return "";
}

std::string body(const std::string& shape) {
  return "[[body]]\nname = \"b\"\nmaterial = \"j\"\n" + shape + "\n";
}

/// True if the text is one line that begins with `begins` and contains the rest.
testing::AssertionResult saysOnce(const std::string& text, const std::string& begins,
                                  const std::string& has) {
  const std::string e = errorOf(text);
  if (e.rfind(begins, 0) == 0 && e.find(has) != std::string::npos && e.find('\n') == std::string::npos)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "got: " << e;
}

TEST(TooFine, BodiesAreReportedAtTheSpacing) {
  const std::string fine = "spacing = 1e-9\n" + around;
  EXPECT_TRUE(saysOnce(fine + body("box = { size = [1, 1, 1] }"),
                       "s.toml:1:11: error: spacing: at 1e-09 m body 'b' would take about 1.0e+27 particles, "
                       "at least 4.0e+20 GB of memory",
                       "(0.01 m makes a million of them)"));
  EXPECT_TRUE(saysOnce(fine + body("sphere = { radius = 0.5 }"),
                       "s.toml:1:11: error: spacing: at 1e-09 m body 'b' would take about 5.2e+26 particles",
                       ""));
  EXPECT_TRUE(saysOnce(fine + body("mesh = \"builtin:bust\""),
                       "s.toml:1:11: error: spacing: at 1e-09 m body 'b' would take about 5",
                       "e+25 particles"));
  EXPECT_TRUE(saysOnce(fine + body("sphere = { radius = 0.5 }") +
                           "[[body]]\nname = \"c\"\nmaterial = \"j\"\nsphere = { radius = 0.1 }\nplace = { "
                           "move = [0, 0, 0.7] }\n",
                       "s.toml:1:11: error: spacing: at 1e-09 m body 'b' and others would take",
                       "particles"));
  EXPECT_TRUE(saysOnce(fine + body("mesh = \"not_read_yet.obj\""),
                       "s.toml:3:1: error: the domain is 1e+09 support radii long along x",
                       "at 1e-09 m it has room for about 8e+27 particles"));
  EXPECT_EQ(errorOf("spacing = 0.01\n" + around + body("box = { size = [1, 1, 1] }")), "");
}

TEST(TooFine, SurfacesAndSheetsAreReportedAtTheSpacingThatApplies) {
  for (const char* source :
       {"patch = { width = 0.4, depth = 0.4 }", "disc = { radius = 0.4 }", "sphere = { radius = 0.4 }",
        "mesh = \"builtin:head\"", "curve = { from = [-0.4, 0, 0], to = [0.4, 0, 0], bulge = 0.1 }",
        "control = [[0, 0, 0], [0.4, 0, 0], [0, 0.4, 0]]"}) {
    const std::string surface = std::string("[[oriented]]\nname = \"o\"\n") + source + "\n";
    EXPECT_TRUE(saysOnce("spacing = 0.05\n" + around + surface + "spacing = 1e-9\n",
                         "s.toml:8:1: error: oriented body 'o': at a spacing of 1e-09 m it would have about",
                         "GB of memory; use a coarser spacing"))
        << source;
    EXPECT_TRUE(saysOnce(
        "spacing = 1e-9\n" + around + surface,
        "s.toml:1:11: error: spacing: oriented body 'o': at a spacing of 1e-09 m it would have about",
        "particles, which take at least"))
        << source;
  }
  const std::string sheet = "[[sheet]]\nname = \"s\"\ngrid = { width = 0.4, depth = 0.4 }\n";
  EXPECT_TRUE(saysOnce(
      "spacing = 1e-9\n" + around + sheet,
      "s.toml:1:11: error: spacing: sheet 's': at a spacing of 1e-09 m it would have about 1.6e+17 vertices",
      "GB of memory"));
}

TEST(TooFine, TooLargeDomainIsReported) {
  EXPECT_TRUE(
      saysOnce("spacing = 0.01\nend = 1\n[domain]\nmin = [-1, -1, -1]\nmax = [1e6, 1, "
               "1]\n[material.j]\nyoung = \"20 kPa\"\n" +
                   body("sphere = { radius = 0.1 }"),
               "s.toml:3:1: error: the domain is 5e+07 support radii long along x", ""));
}

TEST(Title, IsOneLine) {
  EXPECT_EQ(
      errorOf("title = \"\"\"one\ntwo\"\"\"\nspacing = 0.1\n" + around + body("sphere = { radius = 0.5 }")),
      "s.toml:1:9: error: title: expected one line, got a text of several");
  EXPECT_EQ(errorOf("title = \"" + std::string(1000, 'x') + "\"\nspacing = 0.1\n" + around +
                    body("sphere = { radius = 0.5 }")),
            "");
}

}  // namespace
}  // namespace thaw
