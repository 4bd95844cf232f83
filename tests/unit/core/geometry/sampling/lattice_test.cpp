// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/sampling/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/shapes/primitives.hpp"

namespace thaw {
namespace {

TEST(Lattice, EqualCellsFillABoxOfAnyLength) {
  for (double length = 1.5; length < 40; length += 0.0613) {
    const BoxDistance box({length, 2.6, 7});
    for (const Layers layers : {Layers::Cover, Layers::Fit}) {
      const SampleLattice l = sampleLattice(box, 1, layers);
      const auto n = static_cast<double>(l.count[0]);
      EXPECT_NEAR(n * l.cell.x, length, 1e-12);
      EXPECT_LE(std::abs(n - length), 0.5 + 1e-12);
      EXPECT_NEAR(l.at(0, 0, 0).x + 0.5 * length, 0.5 * l.cell.x, 1e-12);
      EXPECT_NEAR(l.mass(0, 1000) * n, 1000 * length * l.cell.y * l.cell.z, 1e-8);
      EXPECT_EQ(l.cell.z, 1) << "a whole number of spacings";
    }
  }
}

TEST(Lattice, ThinBodiesKeepCellsOfOneSpacing) {
  const SampleLattice cover = sampleLattice(BoxDistance({1.4, 0.3, 5}), 1),
                      fit = sampleLattice(BoxDistance({1.4, 0.3, 5}), 1, Layers::Fit);
  EXPECT_EQ(cover.count[0], 2);
  EXPECT_EQ(fit.count[0], 1);
  EXPECT_EQ(cover.count[1], 1);
  for (const SampleLattice& l : {cover, fit}) EXPECT_EQ(l.cell, (Vec3d{1, 1, 1}));
}

Bounds boxAt(double low, double high) { return {{low, low, low}, {high, high, high}}; }

TEST(Lattice, CommonCellsEndAtTheFacesOfAllBoxes) {
  const std::array boxes{boxAt(0, 22.7), boxAt(7.1, 16.4), boxAt(19.3, 30.1)};
  const SampleLattice l = commonLattice(boxes, 1);
  for (int a = 0; a < 3; a++) {
    EXPECT_EQ(l.count[a], static_cast<std::int64_t>(l.faces[a].size()) - 1);
    EXPECT_TRUE(std::ranges::is_sorted(l.faces[a]));
    for (const Bounds& b : boxes)
      for (const double face : {b.min[a], b.max[a]})
        EXPECT_TRUE(std::ranges::find(l.faces[a], face) != l.faces[a].end()) << face;
    for (std::size_t k = 1; k < l.faces[a].size(); k++) {
      const double edge = l.faces[a][k] - l.faces[a][k - 1];
      EXPECT_GE(edge, 0.75);
      EXPECT_LE(edge, 1.3);
    }
  }
  const SampleLattice water = partOf(l, boxes[0]), solid = partOf(l, boxes[1]);
  EXPECT_EQ(solid.count[0], 9);
  EXPECT_EQ(solid.at(0, 0, 0), water.at(7, 7, 7)) << "the same bits";
  double mass = 0;
  for (std::int64_t k = 0; k < water.count[0] * water.rows(); k++) mass += water.mass(k, 1);
  EXPECT_NEAR(mass, 22.7 * 22.7 * 22.7, 1e-8);
}

TEST(Lattice, FacesTooNearToEarlierOnesAreLeftOut) {
  const std::array boxes{boxAt(0, 10), boxAt(0.4, 5.2), boxAt(5.5, 8)};
  const SampleLattice l = commonLattice(boxes, 1);
  const auto has = [&](double face) { return std::ranges::count(l.faces[0], face); };
  EXPECT_EQ(has(0.4), 0);
  EXPECT_EQ(has(5.2), 1);
  EXPECT_EQ(has(5.5), 0);
  EXPECT_EQ(has(8), 1);
}

}  // namespace
}  // namespace thaw
