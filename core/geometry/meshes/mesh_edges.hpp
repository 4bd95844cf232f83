// SPDX-License-Identifier: Apache-2.0
// Edges of a triangle mesh with their triangles.
#pragma once
#include <cstdint>

#include "core/fields/aligned_memory.hpp"
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// One side of a triangle. Sides of the same edge (unordered pair of vertices) are adjacent, sorted by
/// triangle.
struct EdgeSide {
  std::uint64_t edge = 0;  ///< smaller vertex << 32 | larger vertex
  std::uint32_t triangle = 0;
  std::int8_t sign = 0;  ///< +1: the triangle runs from the smaller to the larger vertex
};
/// Requires: the indices of the mesh are valid.
AlignedVector<EdgeSide> edgeSides(const TriangleMesh& mesh);

/// Calls f(first, last) for the range of sides of each edge.
template<class F> void forEachEdge(const AlignedVector<EdgeSide>& sides, F&& f) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].edge == sides[first].edge) last++;
    f(first, last);
    first = last;
  }
}

}  // namespace thaw
