// SPDX-License-Identifier: Apache-2.0
// Local changes of a closed triangle mesh: collapse and flip of an edge, cut of a neck.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Triangles around a vertex: a list without memory of its own up to twelve of them.
class TriangleList {
 public:
  const std::uint32_t* begin() const { return count_ <= own ? few_.data() : many_.data(); }
  const std::uint32_t* end() const { return begin() + count_; }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  void clear() { count_ = 0, many_.clear(); }
  void push_back(std::uint32_t t) {
    if (count_ < own) few_[count_] = t;
    else {
      if (count_ == own) many_.assign(few_.begin(), few_.end());
      many_.push_back(t);
    }
    count_++;
  }
  /// Removes a triangle and keeps the order of the others.
  void erase(std::uint32_t t) {
    const bool wasMany = count_ > own;
    std::uint32_t* first = wasMany ? many_.data() : few_.data();
    std::uint32_t* last = std::remove(first, first + count_, t);
    count_ = static_cast<std::uint32_t>(last - first);
    if (!wasMany) return;
    many_.resize(count_);
    if (count_ <= own) std::copy(many_.begin(), many_.end(), few_.begin());
  }

 private:
  static constexpr std::uint32_t own = 12;
  std::uint32_t count_ = 0;
  std::array<std::uint32_t, own> few_{};
  std::vector<std::uint32_t> many_;  // all of them, if there are more than `own`
};

/// A triangle mesh with the triangles around each vertex. Removed triangles and vertices stay in the lists
/// until `compact`.
///
/// Requires: a closed mesh, with two triangles along each edge. Every change keeps it closed and oriented.
class TriangleEdits {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t removed = 0xffffffffu;  ///< first vertex of a removed triangle

  explicit TriangleEdits(TriangleMesh& mesh);

  TriangleMesh& mesh() { return *mesh_; }
  const TriangleList& around(std::uint32_t vertex) const { return around_[vertex]; }
  const Triangle& triangle(std::uint32_t t) const { return mesh_->triangles[t]; }
  bool exists(std::uint32_t t) const { return mesh_->triangles[t][0] != removed; }

  /// Lists the neighbours of a vertex, once each: each triangle gives the next neighbour around the vertex.
  void neighboursOf(std::uint32_t vertex, std::vector<std::uint32_t>& list) const;

  /// The two triangles along an edge, and their opposite vertices. first: runs from a to b.
  struct Edge {
    std::uint32_t first = removed, second = removed, left = removed, right = removed;
    bool found() const { return first != removed && second != removed; }
  };
  Edge edge(std::uint32_t a, std::uint32_t b) const;

  /// Returns whether the collapse of an edge keeps the mesh a surface (the link condition of DEGN99).
  bool mayCollapse(std::uint32_t from, std::uint32_t to);
  /// Removes vertex `from` and the two triangles of its edge to `to`.
  void collapse(std::uint32_t from, std::uint32_t to);

  /// Returns whether the other diagonal of an edge's quadrangle is no edge yet, and no vertex loses its third
  /// triangle.
  bool mayFlip(std::uint32_t a, std::uint32_t b, const Edge& e) const;
  /// Replaces an edge by the other diagonal of its quadrangle.
  void flip(std::uint32_t a, std::uint32_t b, const Edge& e);

  /// Returns the third vertex of a neck at an edge: a cycle of three edges that is not a triangle. `removed`
  /// if there is none.
  std::uint32_t neckAt(std::uint32_t a, std::uint32_t b);
  /// Cuts the mesh along a neck and closes both ends with a triangle. Appends copies of the three vertices,
  /// in this order. Returns false, without a change, if the edges are not a neck.
  bool cutNeck(const Triangle& neck);

  /// Drops removed triangles and unused vertices. Returns the old index of each vertex that is kept.
  std::vector<std::uint32_t> compact();

 private:
  void drop(std::uint32_t vertex, std::uint32_t triangle);
  /// Lists the triangles around a vertex from its edge to `first` counter-clockwise to its edge to `last`.
  /// Returns false if they do not lead there.
  bool sector(std::uint32_t vertex, std::uint32_t first, std::uint32_t last,
              std::vector<std::uint32_t>& list) const;
  TriangleMesh* mesh_;
  std::vector<TriangleList> around_;
  std::vector<std::uint32_t> near_, other_;
};

}  // namespace thaw
