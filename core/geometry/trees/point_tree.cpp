// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/trees/point_tree.hpp"

#include <algorithm>
#include <nanoflann.hpp>

namespace thaw {
namespace {

struct Cloud {
  std::vector<Vec3d> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t k, std::size_t axis) const { return points[k][static_cast<int>(axis)]; }
  template<class Box> bool kdtree_get_bbox(Box&) const { return false; }
};
using Index =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, std::uint32_t>;

}  // namespace

struct PointTree::Tree {
  Cloud cloud;
  Index index;
  explicit Tree(const std::vector<Vec3d>& points)
      : cloud{points}, index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {
    index.buildIndex();
  }
};

PointTree::PointTree(const std::vector<Vec3d>& points) : tree_(std::make_unique<Tree>(points)) {}
PointTree::~PointTree() = default;
const std::vector<Vec3d>& PointTree::points() const { return tree_->cloud.points; }

std::vector<std::uint32_t> PointTree::nearest(const Vec3d& x, std::size_t count) const {
  const std::vector<Vec3d>& p = points();
  count = std::min(count, p.size());
  if (count == 0) return {};
  // One more point shows whether other points have the distance of the last one.
  std::vector<std::uint32_t> found(std::min(count + 1, p.size()));
  std::vector<double> far2(found.size());
  const double at[3] = {x.x, x.y, x.z};
  const std::size_t n = tree_->index.knnSearch(at, found.size(), found.data(), far2.data());
  found.resize(n);
  const double last = far2[std::min(count, n) - 1];
  // All points with the distance of the last one are included, so ties do not depend on the tree. The added
  // term keeps the square of a tiny radius above 0.
  if (n > count && !(far2[count] > last * (1 + 1e-11) + 1e-290))
    found = within(x, std::sqrt(last) * (1 + 1e-12) + 1e-150);
  std::sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double da = dot(p[a] - x, p[a] - x), db = dot(p[b] - x, p[b] - x);
    return da != db ? da < db : a < b;
  });
  if (found.size() > count) found.resize(count);
  return found;
}

std::vector<std::uint32_t> PointTree::within(const Vec3d& x, double radius) const {
  std::vector<std::uint32_t> found;
  if (points().empty()) return found;
  const double at[3] = {x.x, x.y, x.z};
#if NANOFLANN_VERSION >= 0x150
  std::vector<nanoflann::ResultItem<std::uint32_t, double>> hits;
  tree_->index.radiusSearch(at, radius * radius, hits, nanoflann::SearchParameters());
#else
  std::vector<std::pair<std::uint32_t, double>> hits;
  tree_->index.radiusSearch(at, radius * radius, hits, nanoflann::SearchParams());
#endif
  for (const auto& h : hits) found.push_back(h.first);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace thaw
