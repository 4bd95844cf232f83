// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/trees/triangle_bvh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace thaw {
namespace {

constexpr int mostBins = 16;
constexpr std::uint32_t leafSize = 4;
constexpr std::uint32_t exactRadius = 64;  // largest group of triangles whose radius is computed exactly from
                                           // its corners
constexpr int fairDepth = 40;  // deeper nodes are split by count, which bounds the depth for any input

Vec3d lower(const Vec3d& a, const Vec3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3d upper(const Vec3d& a, const Vec3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

struct Box {
  Vec3d low{never, never, never}, high{-never, -never, -never};
  void add(const Vec3d& x) { low = lower(low, x), high = upper(high, x); }
  void add(const Box& b) { low = lower(low, b.low), high = upper(high, b.high); }
  double area() const {
    const Vec3d d = high - low;
    return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

}  // namespace

struct TriangleBvh::Builder {
  struct Item {
    Box box;
    std::uint32_t triangle = 0;
  };  // partitioned by value, so items of a node are contiguous
  TriangleBvh& tree;
  const TriangleMesh& mesh;
  AlignedVector<Item> items, second;  // second: scratch space for the upper halves

  static Vec3d middleOf(const Item& i) { return 0.5 * (i.box.low + i.box.high); }
  Corners corners(std::uint32_t t) const {
    const auto& v = mesh.triangles[t];
    return {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]};
  }

  /// Returns the split of items[first, last) by the surface area heuristic over bins along the longest
  /// axis of the middles.
  std::uint32_t part(std::uint32_t first, std::uint32_t last, int depth) {
    Box spread;
    for (std::uint32_t k = first; k < last; k++) spread.add(middleOf(items[k]));
    const Vec3d size = spread.high - spread.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = first + (last - first) / 2;
    if (!(size[axis] > 0)) return half;
    const auto along = [&](const Item& i) { return 0.5 * (i.box.low[axis] + i.box.high[axis]); };
    if (depth < fairDepth) {
      const int bins = static_cast<int>(std::min<std::uint32_t>(mostBins, last - first));
      const double low = spread.low[axis], scale = bins / size[axis];
      const auto binOf = [&](const Item& i) {
        return std::min(bins - 1, static_cast<int>((along(i) - low) * scale));
      };
      if (const int split = splitOf(first, last, bins, binOf); split > 0) {
        std::uint32_t kept = first;
        std::size_t above = 0;
        for (std::uint32_t k = first; k < last; k++)
          (binOf(items[k]) < split ? items[kept++] : second[above++]) = items[k];
        std::copy_n(second.begin(), above, items.begin() + kept);
        return kept;
      }
    }
    std::nth_element(items.begin() + first, items.begin() + half, items.begin() + last,
                     [&](const Item& s, const Item& t) {
                       return along(s) != along(t) ? along(s) < along(t) : s.triangle < t.triangle;
                     });
    return half;
  }

  /// Returns the bin before which to split; 0: no split is better.
  template<class BinOf>
  int splitOf(std::uint32_t first, std::uint32_t last, int bins, const BinOf& binOf) const {
    std::array<Box, mostBins> box;
    std::array<std::uint32_t, mostBins> count;
    const auto n = static_cast<std::size_t>(bins);
    for (std::size_t b = 0; b < n; b++) box[b] = {}, count[b] = 0;
    for (std::uint32_t k = first; k < last; k++) {
      const auto b = static_cast<std::size_t>(binOf(items[k]));
      box[b].add(items[k].box);
      count[b]++;
    }
    std::array<double, mostBins> after;
    Box running;
    std::uint32_t those = 0;
    for (std::size_t b = n - 1; b > 0; b--) {
      running.add(box[b]);
      those += count[b];
      after[b] = those > 0 ? running.area() * those : never;
    }
    running = {};
    those = 0;
    double best = never;
    int split = 0;
    for (std::size_t b = 0; b + 1 < n; b++) {
      running.add(box[b]);
      those += count[b];
      const double cost = those > 0 ? running.area() * those + after[b + 1] : never;
      if (cost < best) best = cost, split = static_cast<int>(b) + 1;
    }
    return split;
  }

  /// Fills a leaf and returns its area.
  double makeLeaf(Node& node, Dipole& dipole, std::uint32_t first, std::uint32_t last) {
    node.first = static_cast<std::uint32_t>(tree.triangles_.size());
    node.count = last - first;
    double area = 0;
    for (std::uint32_t k = first; k < last; k++) {
      const Corners t = corners(items[k].triangle);
      tree.triangles_.push_back(t);
      tree.numbers_.push_back(items[k].triangle);
      const Vec3d moment = 0.5 * cross(t.b - t.a, t.c - t.a);
      const double size = length(moment);
      dipole.moment += moment;
      dipole.centre += (t.a + t.b + t.c) * (size / 3);
      area += size;
    }
    dipole.centre = area > 0 ? dipole.centre / area : 0.5 * (node.low + node.high);
    return area;
  }

  /// Creates the node of items[first, last) and its subtree. Returns the node's area.
  double make(std::uint32_t first, std::uint32_t last, int depth) {
    const std::size_t self = tree.nodes_.size(), begin = tree.triangles_.size();
    tree.nodes_.emplace_back();
    tree.dipoles_.emplace_back();
    Node node{};
    Dipole dipole{};
    double area = 0;
    if (last - first <= leafSize) {
      Box box;
      for (std::uint32_t k = first; k < last; k++) box.add(items[k].box);
      node.low = box.low, node.high = box.high;
      area = makeLeaf(node, dipole, first, last);
    } else {
      const std::uint32_t middle = part(first, last, depth);
      const double a = make(first, middle, depth + 1);
      node.first = static_cast<std::uint32_t>(tree.nodes_.size());
      const double b = make(middle, last, depth + 1);
      const Node &left = tree.nodes_[self + 1], &right = tree.nodes_[node.first];
      node.low = lower(left.low, right.low), node.high = upper(left.high, right.high);
      const Dipole &l = tree.dipoles_[self + 1], &r = tree.dipoles_[node.first];
      area = a + b;
      dipole.moment = l.moment + r.moment;
      dipole.centre = area > 0 ? (l.centre * a + r.centre * b) / area : 0.5 * (node.low + node.high);
    }
    dipole.radius2 = last - first <= exactRadius ? radius2Of(begin, dipole.centre)
                                                 : radius2Above(node, dipole.centre, tree.dipoles_[self + 1],
                                                                tree.dipoles_[node.first]);
    tree.nodes_[self] = node;
    tree.dipoles_[self] = dipole;
    return area;
  }

  /// Squared radius about `centre` of the triangles from `begin` on.
  double radius2Of(std::size_t begin, const Vec3d& centre) const {
    double r2 = 0;
    for (std::size_t k = begin; k < tree.triangles_.size(); k++) {
      const Corners& t = tree.triangles_[k];
      for (const Vec3d& x : {t.a, t.b, t.c}) r2 = std::max(r2, dot(x - centre, x - centre));
    }
    return r2;
  }

  /// Upper bound of the squared radius: from the corners of the box or the spheres of the children.
  static double radius2Above(const Node& node, const Vec3d& centre, const Dipole& l, const Dipole& r) {
    const Vec3d corner = upper(centre - node.low, node.high - centre);
    const double balls = std::max(length(l.centre - centre) + std::sqrt(l.radius2),
                                  length(r.centre - centre) + std::sqrt(r.radius2));
    return std::min(dot(corner, corner), balls * balls * (1 + 1e-12));
  }
};

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  if (n == 0) return;
  Builder builder{*this, mesh, AlignedVector<Builder::Item>(n), AlignedVector<Builder::Item>(n)};
  for (std::uint32_t t = 0; t < n; t++) {
    const Corners c = builder.corners(t);
    for (const Vec3d& x : {c.a, c.b, c.c}) builder.items[t].box.add(x);
    builder.items[t].triangle = t;
  }
  triangles_.reserve(n);
  numbers_.reserve(n);
  nodes_.reserve(n);
  dipoles_.reserve(n);
  builder.make(0, n, 0);
}

std::size_t TriangleBvh::memory() const {
  return nodes_.capacity() * sizeof(Node) + dipoles_.capacity() * sizeof(Dipole) +
         triangles_.capacity() * sizeof(Corners) + numbers_.capacity() * sizeof(std::uint32_t);
}

}  // namespace thaw
