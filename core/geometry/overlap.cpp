#include "core/geometry/overlap.hpp"

#include <cmath>

namespace thaw {
namespace {

/// Numbers of periods that bring [low, high] to where it meets [from, to]; without a period 0 or none.
struct Shifts { std::int64_t first, last; };
Shifts shiftsOf(double low, double high, double from, double to, double period) {
  if (!(period > 0) || !(std::isfinite(from) && std::isfinite(to))) return {0, low <= to && high >= from ? 0 : -1};
  return {static_cast<std::int64_t>(std::ceil((from - high) / period)), static_cast<std::int64_t>(std::floor((to - low) / period))};
}

bool meet(const Bounds& p, const Bounds& q, const Vec3d& period) {
  for (int a = 0; a < 3; a++)
    if (const Shifts s = shiftsOf(p.min[a], p.max[a], q.min[a], q.max[a], period[a]); s.first > s.last) return false;
  return true;
}

}  // namespace

std::int64_t OverlapCounts::total() const {
  std::int64_t n = 0;
  for (const std::int64_t c : count) n += c;
  return n;
}

OverlapTest::OverlapTest(std::vector<std::shared_ptr<const SignedDistance>> bodies, const Vec3d& period) : bodies_(std::move(bodies)), period_(period), near_(bodies_.size()) {
  for (const auto& b : bodies_) bounds_.push_back(b->bounds());
  for (std::size_t a = 0; a < bodies_.size(); a++)
    for (std::size_t b = 0; b < bodies_.size(); b++)
      if (a != b && meet(bounds_[a], bounds_[b], period_)) near_[a].push_back(b);
}

/// Is it so for an image of x in the bounds of body b? is(place, moved): moved by a period at least.
template<class Is> bool OverlapTest::anyImage(std::size_t b, const Vec3d& x, Is&& is) const {
  const Bounds& in = bounds_[b];
  Shifts s[3];
  for (int a = 0; a < 3; a++) s[a] = shiftsOf(x[a], x[a], in.min[a], in.max[a], period_[a]);
  for (std::int64_t i = s[0].first; i <= s[0].last; i++)
    for (std::int64_t j = s[1].first; j <= s[1].last; j++)
      for (std::int64_t k = s[2].first; k <= s[2].last; k++) {
        const Vec3d at{x.x + static_cast<double>(i) * period_.x, x.y + static_cast<double>(j) * period_.y, x.z + static_cast<double>(k) * period_.z};
        if (is(at, i != 0 || j != 0 || k != 0)) return true;
      }
  return false;
}

bool OverlapTest::meetsItself(std::size_t a, const Vec3d& x) const {
  return anyImage(a, x, [&](const Vec3d& at, bool moved) { return moved && bodies_[a]->inside(at); });
}

bool OverlapTest::keeps(std::size_t a, const Vec3d& x, OverlapRule rule, OverlapCounts& counts) const {
  bool kept = true;
  for (const std::size_t b : near_[a]) {
    if (!anyImage(b, x, [&](const Vec3d& at, bool) { return bodies_[b]->inside(at); })) continue;
    counts.of(a, b)++;
    if (rule == OverlapRule::RemoveLater && b < a) kept = false;
    if (rule == OverlapRule::RemoveEarlier && b > a) kept = false;
  }
  return kept;
}

std::vector<std::string> describeOverlaps(OverlapCounts counts, const std::vector<Body>& bodies) {
  std::vector<std::string> sentences;
  for (std::size_t a = 0; a < counts.bodies; a++)
    for (std::size_t b = a + 1; b < counts.bodies; b++) {
      if (counts.of(a, b) + counts.of(b, a) == 0) continue;
      const std::string &p = bodies[a].name, &q = bodies[b].name;
      sentences.push_back("bodies '" + p + "' and '" + q + "' overlap: " + std::to_string(counts.of(a, b)) + " particles of '" + p + "' lie inside '" + q +
                          "', " + std::to_string(counts.of(b, a)) + " of '" + q + "' inside '" + p + "'");
    }
  return sentences;
}

}  // namespace thaw
