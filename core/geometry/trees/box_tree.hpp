// SPDX-License-Identifier: Apache-2.0
// Tree of bounding boxes, with queries for boxes that intersect a box.
#pragma once
#include <cstddef>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"

namespace thaw {

class BoxTree {
 public:
  explicit BoxTree(std::vector<Bounds> boxes);
  /// Appends the numbers of all boxes that intersect or touch `box`, in any order.
  void addIntersecting(const Bounds& box, std::vector<std::size_t>& found) const;
  const Bounds& box(std::size_t k) const { return boxes_[k]; }
  std::size_t size() const { return boxes_.size(); }
  /// Bounding box of all boxes; empty (min above max) without boxes.
  Bounds bounds() const;

 private:
  struct Node {
    Bounds around;
    std::size_t begin, end;  ///< range of its boxes in order_
    std::size_t right;       ///< second child; the first child is the next node. 0: a leaf
  };
  std::size_t build(std::size_t begin, std::size_t end);
  std::vector<Bounds> boxes_;
  std::vector<std::size_t> order_;  ///< numbers of boxes, grouped by leaf
  std::vector<Node> nodes_;
};

}  // namespace thaw
