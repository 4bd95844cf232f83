// Nearest neighbours of scattered points, by a kd-tree (nanoflann): the right tool where points have no
// common distance, and so no cell.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

class PointTree {
 public:
  explicit PointTree(const std::vector<Vec3d>& points);  ///< copies them
  ~PointTree();
  /// The `count` nearest points (fewer if there are not so many), nearest first, of equals the lower number
  /// first: the same on any machine.
  std::vector<std::uint32_t> nearest(const Vec3d& x, std::size_t count) const;
  /// All within a radius (m), ascending by number.
  std::vector<std::uint32_t> within(const Vec3d& x, double radius) const;
  const std::vector<Vec3d>& points() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace thaw
