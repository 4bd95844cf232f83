// SPDX-License-Identifier: Apache-2.0
// Vertex rings of a triangle mesh in cyclic order. Consecutive bonds form triangles, so a sheet needs no
// triangle table.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Neighbour in the ring of a vertex. Rings are counter-clockwise, seen from the outer side of the triangles.
struct RingEdge {
  std::uint32_t to;
  bool triangle;  ///< the vertex, `to` and the next neighbour in the ring form a triangle (after the last
                  ///< one, the next is the first of its fan)
  std::uint16_t next;  ///< index in the ring of the neighbour that closes that triangle
  double area;         ///< m^2, of the triangles at the edge
};

inline constexpr std::uint32_t noVertex = 0xffffffffu;

struct SheetTopology {
  std::vector<std::uint32_t> first;  ///< start of each ring, with vertices + 1 entries
  std::vector<RingEdge> ring;
  std::vector<double> area;                          ///< m^2, per vertex: a third of its triangles' area
  std::vector<std::uint32_t> component;              ///< per vertex; components are numbered by their first
                                                     ///< vertices
  std::vector<std::uint8_t> closed;                  ///< per component: every edge has two triangles
  std::vector<double> volume;                        ///< m^3, signed volume of each closed component, else 0
  std::vector<std::array<std::uint32_t, 4>> hinges;  ///< inner edges: ends a < b, and vertices across c < d
};

/// Returns the topology of a mesh whose edges have one or two triangles in opposite directions. Several
/// components, borders, and vertices shared by several fans are allowed. Throws ShapeError for other meshes,
/// triangles without area, and vertices without triangles.
SheetTopology sheetTopology(const TriangleMesh& mesh);

}  // namespace thaw
