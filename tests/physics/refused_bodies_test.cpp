// SPDX-License-Identifier: Apache-2.0
// Oriented bodies and sheets that are refused at the start, with their messages.
#include <gtest/gtest.h>

#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

using test::patchScene;

std::string problemOf(const Scene& s) {
  try {
    test::Simulation x(s);
  } catch (const std::exception& e) { return e.what(); }
  return "";
}

TEST(Oriented, CoincidentBodiesAndDuplicatePointsAreRefused) {
  Scene s = patchScene(0);
  s.oriented.push_back(s.oriented[0]);
  s.oriented[1].name = "second";
  EXPECT_NE(problemOf(s).find("oriented body 'second': 132 of its particles are at positions of 'patch'"),
            std::string::npos)
      << problemOf(s);
  s.oriented[1].shape.move = {0, 0, 0.03};
  EXPECT_EQ(problemOf(s), "");
  s.oriented[0].source = OrientedSource::Points;
  s.oriented[0].points = {{0, 0, 0}, {0.05, 0, 0}, {0, 0.05, 0}, {0, 0, 0}};
  EXPECT_NE(problemOf(s).find("2 of its points are duplicates of another point"), std::string::npos)
      << problemOf(s);
}

TEST(Sheets, VerticesOutsideAndEmptyRegionsAreRefused) {
  Scene s = test::emptyScene(0.05, {-1, -1, -1}, {1, 1, 1});
  s.sheets.emplace_back().name = "cloth";
  s.sheets[0].width = s.sheets[0].depth = 0.5;
  EXPECT_EQ(problemOf(s), "");
  Shape far = test::boxOf({0.8, 0.8, 0.8}, {0.9, 0.9, 0.9});
  s.sheets[0].clamp.push_back(far);
  EXPECT_NE(problemOf(s).find("no vertex lies in this clamp"), std::string::npos) << problemOf(s);
  s.sheets[0].clamp.clear();
  s.sheets[0].regions.emplace_back().shape = far;
  EXPECT_NE(problemOf(s).find("no vertex lies in this region"), std::string::npos) << problemOf(s);
  s.sheets[0].regions.clear();
  s.sheets[0].shape.move = {1, 0, 0};
  EXPECT_NE(
      problemOf(s).find(
          "66 of its 121 vertices lie outside of the domain, up to 0.25 m beyond its side x = 1 m; enlarge"),
      std::string::npos)
      << problemOf(s);
}

}  // namespace
}  // namespace thaw
