// SPDX-License-Identifier: Apache-2.0
// A surface through a few control points passes through them as created, relaxed and run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/oriented/mesh/triangulate.hpp"
#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

struct Figure {
  const char* name;
  std::vector<Vec3d> points;
};

std::vector<Figure> figures() {
  std::vector<Figure> all;
  all.push_back({"corners and a raised middle",
                 {{-0.4, -0.4, 0}, {0.4, -0.4, 0}, {-0.4, 0.4, 0}, {0.4, 0.4, 0}, {0.01, 0.02, 0.25}}});
  all.push_back({"saddle", {{-0.4, -0.4, 0.15}, {0.4, -0.4, -0.15}, {-0.4, 0.4, -0.15}, {0.4, 0.4, 0.15}}});
  Figure ring{"ring of eight", {}};
  for (int k = 0; k < 8; k++)
    ring.points.push_back({0.42 * std::cos(0.78539816 * k + 0.1), 0.42 * std::sin(0.78539816 * k + 0.1),
                           0.12 * std::cos(1.5707963 * k)});
  all.push_back(ring);
  return all;
}

/// Largest distance in spacings of a control point from the body: the largest part of its particles connected
/// within 1.5 spacings.
double farthestFromBody(const Oriented& o, const std::vector<Vec3d>& points, double spacing) {
  std::vector<std::size_t> part(o.owned, o.owned);
  std::vector<std::size_t> size;
  for (std::size_t first = 0; first < o.owned; first++) {
    if (part[first] < o.owned) continue;
    std::vector<std::size_t> open{first};
    part[first] = size.size();
    size.push_back(0);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      size.back()++;
      for (std::size_t j = 0; j < o.owned; j++)
        if (part[j] == o.owned && length(o.position[j] - o.position[i]) < 1.5 * spacing)
          part[j] = size.size() - 1, open.push_back(j);
    }
  }
  const auto body = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  double most = 0;
  for (const Vec3d& point : points) {
    double nearest = never;
    for (std::size_t i = 0; i < o.owned; i++)
      if (part[i] == body) nearest = std::min(nearest, length(o.position[i] - point));
    most = std::max(most, nearest / spacing);
  }
  return most;
}

Scene controlScene(const std::vector<Vec3d>& points) {
  Scene s = test::patchScene(0);
  OrientedBody& b = s.oriented[0];
  b.source = OrientedSource::Control;
  b.points = points;
  b.damping = b.spinDamping = 5;
  return s;
}

TEST(OrientedControl, PassesThroughItsControlPoints) {
  for (const Figure& f : figures()) {
    test::Simulation x(controlScene(f.points));
    EXPECT_LT(farthestFromBody(x.w.oriented.rows, f.points, x.w.scene.spacing), 1e-9) << f.name;
  }
}

TEST(OrientedControl, KeepsThemDuringAndAfterRelaxation) {
  for (const Figure& f : figures()) {
    Scene s = controlScene(f.points);
    s.oriented[0].relax = 1500;
    s.end = 0.5;
    test::Simulation x(s);
    const Oriented& o = x.w.oriented.rows;
    const double relaxed = farthestFromBody(o, f.points, s.spacing);
    ASSERT_TRUE(x.run());
    const double end = farthestFromBody(o, f.points, s.spacing);
    const LedgerReport l = x.ledgerReport();
    std::printf("%s: %.3f spacings off when relaxed, %.3f at the end; residual %.1e of %.1e J\n", f.name,
                relaxed, end, l.energyResidual, l.energyScale);
    EXPECT_LT(relaxed, 0.5) << f.name;
    EXPECT_LT(end, 0.5) << f.name;
    EXPECT_LT(std::abs(l.energyResidual), 1e-3 * l.energyScale) << f.name;
    EXPECT_LT(length(l.momentumResidual), 1e-12 * (1 + length(l.wallImpulse))) << f.name;
  }
}

// A fine plate with too few particles for its area would tear around the constrained ones.
TEST(OrientedControl, KeepsThemOnASteepFinePlate) {
  const Figure f = figures()[0];
  Scene s = controlScene(f.points);
  s.spacing = 0.028;
  s.oriented[0].relax = 400;
  test::Simulation x(s);
  EXPECT_LT(farthestFromBody(x.w.oriented.rows, f.points, s.spacing), 0.5);
}

TEST(OrientedControl, KeepsThemWithoutRelaxation) {
  for (const Figure& f : figures()) {
    Scene s = controlScene(f.points);
    s.end = 0.5;
    test::Simulation x(s);
    ASSERT_TRUE(x.run());
    EXPECT_LT(farthestFromBody(x.w.oriented.rows, f.points, s.spacing), 0.5) << f.name;
  }
}

}  // namespace
}  // namespace thaw
