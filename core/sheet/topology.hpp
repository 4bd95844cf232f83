// The neighbours of every vertex of a triangle mesh in the order in which they lie round it, so that
// triangles are consecutive bonds and a sheet needs no table of triangles.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

/// A neighbour in the ring of a vertex. Rings run counter-clockwise seen from the side that triangles face.
struct RingEdge {
  std::uint32_t to;
  bool triangle;  ///< the vertex, `to` and the next of the ring (after the last one, the first of its fan)
                  ///< are a triangle
  std::uint16_t next;  ///< number in the ring of the neighbour that closes that triangle
  double area;         ///< m^2, of the triangles at the edge
};

inline constexpr std::uint32_t noVertex = 0xffffffffu;

struct SheetTopology {
  std::vector<std::uint32_t> first;  ///< vertices + 1: where the ring of each begins
  std::vector<RingEdge> ring;
  std::vector<double> area;              ///< m^2, of each vertex: a third of its triangles
  std::vector<std::uint32_t> component;  ///< of each vertex, numbered by their first vertices
  std::vector<std::uint8_t> closed;      ///< of each component: every edge has two triangles
  std::vector<double> volume;  ///< m^3, of each closed component, by its triangles' directions; else 0
  std::vector<std::array<std::uint32_t, 4>> hinges;  ///< of inner edges: a < b and the vertices across, c < d
};

/// Any mesh whose edges have one or two triangles that run through them opposite ways; several components,
/// borders, and vertices at which fans of triangles meet in a point are fine. Throws ShapeError where that is
/// not so, or a triangle has no area or a vertex no triangle.
SheetTopology sheetTopology(const TriangleMesh& mesh);

}  // namespace thaw
