// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/geometry/trees/box_tree.hpp"

namespace thaw {
namespace {

/// Multiples of the period by which [low, high] must move to intersect [from, to]. Without a period, only 0
/// is possible.
struct Shifts {
  std::int64_t first, last;
};
Shifts shiftsOf(double low, double high, double from, double to, double period) {
  if (!(period > 0) || !(std::isfinite(from) && std::isfinite(to)))
    return {0, low <= to && high >= from ? 0 : -1};
  return {static_cast<std::int64_t>(std::ceil((from - high) / period)),
          static_cast<std::int64_t>(std::floor((to - low) / period))};
}

/// Returns the other boxes that intersect box b or one of its periodic images, ascending.
std::vector<std::size_t> intersecting(const BoxTree& tree, std::size_t b, const Vec3d& period) {
  const Bounds &own = tree.box(b), around = tree.bounds();
  Shifts s[3];
  for (int a = 0; a < 3; a++)
    s[a] = shiftsOf(own.min[a], own.max[a], around.min[a], around.max[a], period[a]);
  std::vector<std::size_t> found;
  for (std::int64_t i = s[0].first; i <= s[0].last; i++)
    for (std::int64_t j = s[1].first; j <= s[1].last; j++)
      for (std::int64_t k = s[2].first; k <= s[2].last; k++) {
        const Vec3d n{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
        const Vec3d by{n.x * period.x, n.y * period.y, n.z * period.z};
        tree.addIntersecting({own.min + by, own.max + by}, found);
      }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::erase(found, b);
  return found;
}

}  // namespace

std::int64_t OverlapCounts::of(std::size_t a, std::size_t b) const {
  const auto at = std::ranges::lower_bound(pair, std::pair(a, b));
  return at != pair.end() && *at == std::pair(a, b) ? count[static_cast<std::size_t>(at - pair.begin())] : 0;
}

std::int64_t OverlapCounts::total() const {
  std::int64_t n = 0;
  for (const std::int64_t c : count) n += c;
  return n;
}

OverlapTest::OverlapTest(std::vector<std::shared_ptr<const SignedDistance>> bodies, const Vec3d& period)
    : bodies_(std::move(bodies)), period_(period) {
  for (const auto& b : bodies_) bounds_.push_back(b->bounds());
  const BoxTree tree(bounds_);
  first_.push_back(0);
  for (std::size_t a = 0; a < bodies_.size(); a++) {
    const std::vector<std::size_t> others = intersecting(tree, a, period_);
    near_.insert(near_.end(), others.begin(), others.end());
    first_.push_back(near_.size());
  }
}

OverlapCounts OverlapTest::noCounts() const {
  OverlapCounts counts;
  for (std::size_t a = 0; a < bodies_.size(); a++)
    for (std::size_t k = first_[a]; k < first_[a + 1]; k++) counts.pair.push_back({a, near_[k]});
  counts.count.resize(counts.pair.size(), 0);
  return counts;
}

/// Returns true if test(position, moved) holds for an image of x in the bounds of body b. moved: true if the
/// image is moved by at least one period.
template<class Test> bool OverlapTest::anyImage(std::size_t b, const Vec3d& x, Test&& test) const {
  const Bounds& in = bounds_[b];
  Shifts s[3];
  for (int a = 0; a < 3; a++) s[a] = shiftsOf(x[a], x[a], in.min[a], in.max[a], period_[a]);
  for (std::int64_t i = s[0].first; i <= s[0].last; i++)
    for (std::int64_t j = s[1].first; j <= s[1].last; j++)
      for (std::int64_t k = s[2].first; k <= s[2].last; k++) {
        const Vec3d at{x.x + static_cast<double>(i) * period_.x, x.y + static_cast<double>(j) * period_.y,
                       x.z + static_cast<double>(k) * period_.z};
        if (test(at, i != 0 || j != 0 || k != 0)) return true;
      }
  return false;
}

bool OverlapTest::meetsItself(std::size_t a, const Vec3d& x) const {
  return anyImage(a, x, [&](const Vec3d& at, bool moved) { return moved && bodies_[a]->inside(at); });
}

bool OverlapTest::keeps(std::size_t a, const Vec3d& x, OverlapRule rule, OverlapCounts& counts) const {
  bool kept = true;
  for (std::size_t k = first_[a]; k < first_[a + 1]; k++) {
    const std::size_t b = near_[k];
    if (!anyImage(b, x, [&](const Vec3d& at, bool) { return bodies_[b]->inside(at); })) continue;
    counts.count[k]++;
    if (rule == OverlapRule::RemoveLater && b < a) kept = false;
    if (rule == OverlapRule::RemoveEarlier && b > a) kept = false;
  }
  return kept;
}

std::vector<BodyOverlap> describeOverlaps(const OverlapCounts& counts, const std::vector<Body>& bodies) {
  // For pairs (a < b): samples of a in b, samples of b in a.
  std::map<std::pair<std::size_t, std::size_t>, std::array<std::int64_t, 2>> found;
  for (std::size_t k = 0; k < counts.pair.size(); k++) {
    if (counts.count[k] == 0) continue;
    const auto [a, b] = counts.pair[k];
    found[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1] = counts.count[k];
  }
  std::vector<BodyOverlap> overlaps;
  for (const auto& [pair, count] : found) {
    const std::string &p = bodies[pair.first].name, &q = bodies[pair.second].name;
    overlaps.push_back({pair.first, pair.second,
                        "bodies '" + p + "' and '" + q + "' overlap: " + std::to_string(count[0]) +
                            " particles of '" + p + "' lie inside '" + q + "', " + std::to_string(count[1]) +
                            " of '" + q + "' inside '" + p + "'"});
  }
  return overlaps;
}

}  // namespace thaw
