// SPDX-License-Identifier: Apache-2.0
// Estimated numbers of particles and vertices against the created ones.
#include "core/simulation/setup/estimates/expected_rows.hpp"

#include <gtest/gtest.h>

#include "core/oriented/sampling/sample_points.hpp"
#include "core/sheet/data/plan_sheets.hpp"
#include "core/simulation/setup/make_grid.hpp"

namespace thaw {
namespace {

Scene sceneOf(double spacing) {
  Scene s;
  s.spacing = spacing;
  return s;
}

TEST(ExpectedRows, ApproximateThoseOfOrientedBodies) {
  Scene s = sceneOf(0.02);
  for (int k = 0; k < 6; k++) s.oriented.emplace_back();
  s.oriented[0].source = OrientedSource::Patch;
  s.oriented[0].shape.scale = 0.5;
  s.oriented[1].source = OrientedSource::Disc;
  s.oriented[2].source = OrientedSource::Curve;
  s.oriented[2].bulge = 0.2;
  s.oriented[3].source = OrientedSource::Control;
  s.oriented[3].points = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0.1}, {0.5, 0.5, 0.1}};
  s.oriented[4].shape.kind = ShapeKind::Sphere;
  s.oriented[4].shape.radius = 0.2;
  s.oriented[5].shape.kind = ShapeKind::Mesh;
  s.oriented[5].shape.mesh = "builtin:head";
  s.oriented[5].shape.scale = 0.3;
  const std::vector<ExpectedRows> expected = expectedRows(s, {});
  ASSERT_EQ(expected.size(), s.oriented.size());
  for (std::size_t k = 0; k < expected.size(); k++) {
    const double made = static_cast<double>(samplePoints(s.oriented[k], s.spacing, 1, {}).places.size());
    EXPECT_GT(expected[k].rows, 0.65 * made) << k;
    EXPECT_LT(expected[k].rows, (k == 3 ? 2.2 : 1.4) * made) << k;  // 3: the square around the hull
    EXPECT_EQ(expected[k].spread, k >= 3) << k;
  }
}

TEST(ExpectedRows, EqualThoseOfSheets) {
  Scene s = sceneOf(0.03);
  for (const SheetMesh mesh :
       {SheetMesh::Grid, SheetMesh::Sphere, SheetMesh::Head, SheetMesh::Dome, SheetMesh::Forehead}) {
    s.sheets.emplace_back();
    s.sheets.back().mesh = mesh;
    s.sheets.back().width = 0.4;
    s.sheets.back().height = 0.3;
  }
  const std::vector<ExpectedRows> expected = expectedRows(s, {});
  for (std::size_t k = 0; k < expected.size(); k++)
    EXPECT_EQ(expected[k].rows, static_cast<double>(sheetMesh(s, s.sheets[k], {}).vertices.size())) << k;
}

TEST(ExpectedRows, NoSpacingOverflows) {
  Scene s = sceneOf(1e-12);
  s.oriented.emplace_back().source = OrientedSource::Patch;
  s.sheets.emplace_back();
  for (const ExpectedRows& e : expectedRows(s, {})) EXPECT_GT(e.rows, 1e23);
}

// A surface that is much finer than the scene's spacing, without a continuum: cells follow the range of its
// particles, or each would hold thousands.
TEST(ExpectedRows, CellsFollowTheFinestBodyWithoutAContinuum) {
  Scene s = sceneOf(0.05);
  s.oriented.emplace_back().spacing = 1e-3;
  EXPECT_LT(makeGrid(s).edge.x, 5e-3);
  s.bodies.emplace_back();
  EXPECT_GE(makeGrid(s).edge.x, 0.05 * s.numerics.support);
}

TEST(SampledPoints, ScaledPatchKeepsItsSpacing) {
  OrientedBody b;
  b.source = OrientedSource::Patch;
  b.shape.scale = 2;
  const SampledPoints m = samplePoints(b, 0.1, 1, {});
  EXPECT_NEAR(length(m.places[1] - m.places[0]), 0.1, 1e-12);
  EXPECT_NEAR(m.places.back().y - m.places.front().y, 2, 0.1);
}

}  // namespace
}  // namespace thaw
