// Triangles in a view of surfels: sheets and triangulated oriented bodies share light, shadow and depth with
// surfels, and have no gaps at folds.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/render/render_frames.hpp"

namespace thaw {

/// What a mesh brings: one element a vertex; values may be empty (then the colours show).
struct DrawnMesh {
  std::span<const Vec3f> positions;  ///< m
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const float> values;
  std::span<const Rgb> colours;
};

/// Adds both sides of a mesh, with normals that turn smoothly from vertex to vertex.
void addMeshFaces(const DrawnMesh& mesh, FrameView& view);

/// A corner of a triangle as it is lit.
struct FaceCorner {
  Vec3f place, normal;
  Rgb colour, back;  ///< of the side of the normal, and of the other
};

/// Adds both sides of one triangle with corners of its own, whose normals need not be those of its
/// neighbours.
void addFace(const std::array<FaceCorner, 3>& corners, FrameView& view);

}  // namespace thaw
