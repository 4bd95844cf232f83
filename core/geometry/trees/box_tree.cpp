// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/trees/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace thaw {
namespace {

constexpr std::size_t inLeaf = 8;

bool meet(const Bounds& p, const Bounds& q) {
  for (int a = 0; a < 3; a++)
    if (!(p.min[a] <= q.max[a] && p.max[a] >= q.min[a])) return false;
  return true;
}

/// Returns 0 for an infinite box.
double middle(const Bounds& b, int axis) {
  const double m = 0.5 * (b.min[axis] + b.max[axis]);
  return std::isfinite(m) ? m : 0;
}

}  // namespace

BoxTree::BoxTree(std::vector<Bounds> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!boxes_.empty()) build(0, boxes_.size());
}

Bounds BoxTree::bounds() const {
  if (nodes_.empty()) return {{never, never, never}, {-never, -never, -never}};
  return nodes_.front().around;
}

std::size_t BoxTree::build(std::size_t begin, std::size_t end) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({boxes_[order_[begin]], begin, end, 0});
  Vec3d low{never, never, never}, high{-never, -never, -never};  // bounds of the middles
  for (std::size_t k = begin; k < end; k++) {
    const Bounds& b = boxes_[order_[k]];
    Bounds& around = nodes_[node].around;
    for (int a = 0; a < 3; a++) {
      around.min[a] = std::min(around.min[a], b.min[a]);
      around.max[a] = std::max(around.max[a], b.max[a]);
      low[a] = std::min(low[a], middle(b, a));
      high[a] = std::max(high[a], middle(b, a));
    }
  }
  if (end - begin <= inLeaf) return node;
  const Vec3d wide = high - low;
  const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(half), at(end), [&](std::size_t p, std::size_t q) {
    return std::pair(middle(boxes_[p], axis), p) < std::pair(middle(boxes_[q], axis), q);
  });
  build(begin, half);
  nodes_[node].right = build(half, end);
  return node;
}

void BoxTree::addIntersecting(const Bounds& box, std::vector<std::size_t>& found) const {
  if (nodes_.empty()) return;
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    const Node& node = nodes_[at];
    if (!meet(node.around, box)) continue;
    if (node.right > 0) {
      open.push_back(node.right);
      open.push_back(at + 1);
      continue;
    }
    for (std::size_t k = node.begin; k < node.end; k++)
      if (meet(boxes_[order_[k]], box)) found.push_back(order_[k]);
  }
}

}  // namespace thaw
