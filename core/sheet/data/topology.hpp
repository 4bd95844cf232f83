// SPDX-License-Identifier: Apache-2.0
// Vertex rings of a triangle mesh in cyclic order: triangles are consecutive bonds, and a sheet needs no
// triangle table.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

/// Neighbour in the ring of a vertex. Rings run counter-clockwise seen from the side that triangles face.
struct RingEdge {
  std::uint32_t to;
  bool triangle;  ///< the vertex, `to` and the next of the ring (after the last, the first of its fan) are a
                  ///< triangle
  std::uint16_t next;  ///< index in the ring of the neighbour that closes that triangle
  double area;         ///< m^2, of the triangles at the edge
};

inline constexpr std::uint32_t noVertex = 0xffffffffu;

struct SheetTopology {
  std::vector<std::uint32_t> first;  ///< vertices + 1: start of each ring
  std::vector<RingEdge> ring;
  std::vector<double> area;                          ///< m^2, per vertex: a third of its triangles
  std::vector<std::uint32_t> component;              ///< per vertex, numbered by first vertices
  std::vector<std::uint8_t> closed;                  ///< per component: every edge has two triangles
  std::vector<double> volume;                        ///< m^3, signed volume of each closed component, else 0
  std::vector<std::array<std::uint32_t, 4>> hinges;  ///< inner edges: a < b and the vertices across, c < d
};

/// Returns the topology of a mesh whose edges have one or two triangles in opposite directions. Several
/// components, borders, and vertices shared by several fans are allowed. Throws ShapeError for other meshes,
/// triangles without area, and vertices without triangles.
SheetTopology sheetTopology(const TriangleMesh& mesh);

}  // namespace thaw
