#include "core/geometry/overlap.hpp"

namespace thaw {
namespace {

bool holds(const Bounds& b, const Vec3d& x) {
  for (int a = 0; a < 3; a++)
    if (x[a] < b.min[a] || x[a] > b.max[a]) return false;
  return true;
}

bool meet(const Bounds& p, const Bounds& q) {
  for (int a = 0; a < 3; a++)
    if (p.max[a] < q.min[a] || q.max[a] < p.min[a]) return false;
  return true;
}

}  // namespace

std::int64_t OverlapCounts::total() const {
  std::int64_t n = 0;
  for (const std::int64_t c : count) n += c;
  return n;
}

OverlapTest::OverlapTest(std::vector<std::shared_ptr<const SignedDistance>> bodies) : bodies_(std::move(bodies)), near_(bodies_.size()) {
  for (const auto& b : bodies_) bounds_.push_back(b->bounds());
  for (std::size_t a = 0; a < bodies_.size(); a++)
    for (std::size_t b = 0; b < bodies_.size(); b++)
      if (a != b && meet(bounds_[a], bounds_[b])) near_[a].push_back(b);
}

bool OverlapTest::keeps(std::size_t a, const Vec3d& x, OverlapRule rule, OverlapCounts& counts) const {
  bool kept = true;
  for (const std::size_t b : near_[a]) {
    if (!holds(bounds_[b], x) || !bodies_[b]->inside(x)) continue;
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
