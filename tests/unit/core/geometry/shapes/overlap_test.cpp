// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/overlap.hpp"

#include <gtest/gtest.h>

#include "core/math/hash_random.hpp"
#include "tests/support/samples.hpp"

namespace thaw {
namespace {

TEST(Overlap, FollowsItsRulesAndCounts) {
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  std::vector<Body> bodies(3);
  for (int k = 0; k < 3; k++) {  // boxes of 10 x 10 x 10 in a row: the first two share 4 layers, the third
                                 // touches the second
    Shape s;
    s.move = {k == 0 ? 0.0 : k == 1 ? 0.6 : 1.6, 0, 0};
    shapes.push_back(makeSignedDistance(s));
    bodies[static_cast<std::size_t>(k)].name = std::string(1, static_cast<char>('a' + k));
  }
  const OverlapTest test(shapes);
  const auto kept = [&](OverlapRule rule, OverlapCounts& counts) {
    std::vector<std::size_t> n(3, 0);
    for (std::size_t a = 0; a < 3; a++) {
      const SampleLattice l = sampleLattice(*shapes[a], 0.1);
      for (const Vec3d& x : sampleShape(*shapes[a], l, {0, l.rows()}).position)
        n[a] += test.keeps(a, x, rule, counts);
    }
    return n;
  };
  for (const OverlapRule rule :
       {OverlapRule::Error, OverlapRule::Keep, OverlapRule::RemoveLater, OverlapRule::RemoveEarlier}) {
    OverlapCounts counts = test.noCounts();
    const auto n = kept(rule, counts);
    EXPECT_EQ(n[0], rule == OverlapRule::RemoveEarlier ? 600u : 1000u);
    EXPECT_EQ(n[1], rule == OverlapRule::RemoveLater ? 600u : 1000u);
    EXPECT_EQ(n[2], 1000u);
    EXPECT_EQ(counts.of(0, 1), 400);
    EXPECT_EQ(counts.of(1, 0), 400);
    EXPECT_EQ(counts.total(), 800);
    const auto overlaps = describeOverlaps(counts, bodies);
    ASSERT_EQ(overlaps.size(), 1u);
    EXPECT_EQ(overlaps[0].first, 0u);
    EXPECT_EQ(overlaps[0].second, 1u);
    EXPECT_EQ(overlaps[0].text,
              "bodies 'a' and 'b' overlap: 400 particles of 'a' lie inside 'b', 400 of 'b' inside 'a'");
  }
}

TEST(Overlap, IsFoundAcrossPeriodicSides) {
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  // Boxes of 10 x 10 x 10 in a domain of 2.4 m. The second reaches over the side into the first by 2 layers,
  // the third around the domain into itself by 4.
  Shape s;
  for (const double x : {0.5, 2.1, 1.2}) {
    s.move = {x, x == 1.2 ? 5.0 : 0.0, 0};
    s.size = {x == 1.2 ? 2.6 : 1.0, 1, 1};
    shapes.push_back(makeSignedDistance(s));
  }
  const OverlapTest test(shapes, {2.4, 0, 0}), open(shapes);
  OverlapCounts counts = test.noCounts(), none = open.noCounts();
  std::vector<std::size_t> itself(3, 0), never(3, 0);
  for (std::size_t a = 0; a < 3; a++) {
    const SampleLattice l = sampleLattice(*shapes[a], 0.1);
    for (const Vec3d& x : sampleShape(*shapes[a], l, {0, l.rows()}).position) {
      test.keeps(a, x, OverlapRule::Keep, counts);
      open.keeps(a, x, OverlapRule::Keep, none);
      itself[a] += test.meetsItself(a, x);
      never[a] += open.meetsItself(a, x);
    }
  }
  EXPECT_EQ(counts.of(0, 1), 200);
  EXPECT_EQ(counts.of(1, 0), 200);
  EXPECT_EQ(counts.total(), 400);
  EXPECT_EQ(none.total(), 0);
  EXPECT_EQ(itself, (std::vector<std::size_t>{0, 0, 400}));
  EXPECT_EQ(never, (std::vector<std::size_t>{0, 0, 0}));
}

/// 1,000 boxes of different sizes at random positions: the same pairs as by testing all.
TEST(Overlap, FindsAllPairsOfOverlappingBoxes) {
  constexpr std::size_t n = 1000;
  const Vec3d period{3, 0, 2};
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (std::size_t k = 0; k < n; k++) {
    Shape s;
    for (int a = 0; a < 3; a++)
      s.move[a] = 3 * randomUniform(7, Purpose::Jitter, k, static_cast<std::uint64_t>(a)),
      s.size[a] = 0.4 * randomUniform(8, Purpose::Jitter, k, static_cast<std::uint64_t>(a)) + 0.01;
    if (k % 100 == 0) s.size.x = 2.9;
    shapes.push_back(makeSignedDistance(s));
  }
  const auto meet = [&](const Bounds& p, const Bounds& q) {
    for (int a = 0; a < 3; a++) {
      bool any = false;
      for (int shift = -3; shift <= 3; shift++)
        any = any || (p.min[a] + shift * period[a] <= q.max[a] && p.max[a] + shift * period[a] >= q.min[a]);
      if (!any) return false;
    }
    return true;
  };
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t a = 0; a < n; a++)
    for (std::size_t b = 0; b < n; b++)
      if (a != b && meet(shapes[a]->bounds(), shapes[b]->bounds())) all.push_back({a, b});
  EXPECT_GT(all.size(), n);
  EXPECT_EQ(OverlapTest(shapes, period).noCounts().pair, all);
}

}  // namespace
}  // namespace thaw
