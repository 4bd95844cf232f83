// SPDX-License-Identifier: Apache-2.0
// Nearest neighbours of scattered points without a common spacing, by a kd-tree (nanoflann).
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

class PointTree {
 public:
  explicit PointTree(const std::vector<Vec3d>& points);  ///< copies the points
  ~PointTree();
  /// Returns the `count` nearest points, or all if there are fewer. The nearest point is first; of equal
  /// distances, the lower number is first. The result is the same on all machines.
  std::vector<std::uint32_t> nearest(const Vec3d& x, std::size_t count) const;
  /// Returns all points within a radius (m), ascending by number.
  std::vector<std::uint32_t> within(const Vec3d& x, double radius) const;
  const std::vector<Vec3d>& points() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace thaw
