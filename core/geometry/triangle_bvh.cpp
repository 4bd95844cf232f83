#include "core/geometry/triangle_bvh.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace thaw {
namespace {

constexpr int binCount = 16;
constexpr std::uint32_t leafSize = 4;
constexpr int fairDepth = 40;  // below it halves are made by count, so that no input makes the tree deep

Vec3d lower(const Vec3d& a, const Vec3d& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3d upper(const Vec3d& a, const Vec3d& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

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
  TriangleBvh& tree;
  const TriangleMesh& mesh;
  std::vector<Box> boxes;
  std::vector<Vec3d> middles;
  std::vector<std::uint32_t> order;

  Corners corners(std::uint32_t t) const {
    const auto& v = mesh.triangles[t];
    return {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]};
  }

  /// Where to part order[first, last): by the surface area heuristic over bins along the longest axis of the middles.
  std::uint32_t part(std::uint32_t first, std::uint32_t last, int depth) {
    Box spread;
    for (std::uint32_t k = first; k < last; k++) spread.add(middles[order[k]]);
    const Vec3d size = spread.high - spread.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = first + (last - first) / 2;
    if (!(size[axis] > 0)) return half;
    const auto begin = order.begin() + first, end = order.begin() + last;
    if (depth < fairDepth) {
      const double low = spread.low[axis], scale = binCount / size[axis];
      const auto binOf = [&](std::uint32_t t) { return std::min(binCount - 1, static_cast<int>((middles[t][axis] - low) * scale)); };
      std::array<Box, binCount> box;
      std::array<std::uint32_t, binCount> count{};
      for (auto t = begin; t != end; ++t) {
        const auto b = static_cast<std::size_t>(binOf(*t));
        box[b].add(boxes[*t]);
        count[b]++;
      }
      std::array<double, binCount> after{};
      Box running;
      std::uint32_t n = 0;
      for (std::size_t b = binCount - 1; b > 0; b--) {
        running.add(box[b]);
        n += count[b];
        after[b] = n > 0 ? running.area() * n : never;
      }
      running = {};
      n = 0;
      double best = never;
      int split = 0;
      for (std::size_t b = 0; b + 1 < binCount; b++) {
        running.add(box[b]);
        n += count[b];
        const double cost = n > 0 ? running.area() * n + after[b + 1] : never;
        if (cost < best) best = cost, split = static_cast<int>(b) + 1;
      }
      if (best < never) {
        const auto middle = std::stable_partition(begin, end, [&](std::uint32_t t) { return binOf(t) < split; });
        return static_cast<std::uint32_t>(middle - order.begin());
      }
    }
    std::nth_element(begin, order.begin() + half, end, [&](std::uint32_t s, std::uint32_t t) {
      return middles[s][axis] != middles[t][axis] ? middles[s][axis] < middles[t][axis] : s < t;
    });
    return half;
  }

  /// Returns the area.
  double makeLeaf(Node& node, Dipole& dipole, std::uint32_t first, std::uint32_t last) {
    node.first = static_cast<std::uint32_t>(tree.triangles_.size());
    node.count = last - first;
    double area = 0;
    for (std::uint32_t k = first; k < last; k++) {
      const Corners t = corners(order[k]);
      tree.triangles_.push_back(t);
      tree.numbers_.push_back(order[k]);
      const Vec3d moment = 0.5 * cross(t.b - t.a, t.c - t.a);
      dipole.moment += moment;
      dipole.centre += (t.a + t.b + t.c) * (length(moment) / 3);
      area += length(moment);
    }
    dipole.centre = area > 0 ? dipole.centre / area : 0.5 * (node.low + node.high);
    return area;
  }

  /// Makes the node of order[first, last) and all below it; returns its area.
  double make(std::uint32_t first, std::uint32_t last, int depth) {
    const std::size_t self = tree.nodes_.size(), begin = tree.triangles_.size();
    tree.nodes_.emplace_back();
    tree.dipoles_.emplace_back();
    Node node{};
    Dipole dipole{};
    double area = 0;
    if (last - first <= leafSize) {
      Box box;
      for (std::uint32_t k = first; k < last; k++) box.add(boxes[order[k]]);
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
    for (std::size_t k = begin; k < tree.triangles_.size(); k++) {  // of the tree and not of the mesh: they lie side by side
      const Corners& t = tree.triangles_[k];
      for (const Vec3d& x : {t.a, t.b, t.c}) dipole.radius2 = std::max(dipole.radius2, dot(x - dipole.centre, x - dipole.centre));
    }
    tree.nodes_[self] = node;
    tree.dipoles_[self] = dipole;
    return area;
  }
};

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  if (n == 0) return;
  Builder builder{*this, mesh, std::vector<Box>(n), std::vector<Vec3d>(n), std::vector<std::uint32_t>(n)};
  for (std::uint32_t t = 0; t < n; t++) {
    const Corners c = builder.corners(t);
    for (const Vec3d& x : {c.a, c.b, c.c}) builder.boxes[t].add(x);
    builder.middles[t] = 0.5 * (builder.boxes[t].low + builder.boxes[t].high);
  }
  std::iota(builder.order.begin(), builder.order.end(), 0u);
  triangles_.reserve(n);
  numbers_.reserve(n);
  nodes_.reserve(n);
  dipoles_.reserve(n);
  builder.make(0, n, 0);
}

std::size_t TriangleBvh::memory() const {
  return nodes_.capacity() * sizeof(Node) + dipoles_.capacity() * sizeof(Dipole) + triangles_.capacity() * sizeof(Corners) + numbers_.capacity() * sizeof(std::uint32_t);
}

}  // namespace thaw
