// Sheets and particles as discs, so that they are drawn with surfels in one picture.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/render/render_frames.hpp"

namespace thaw {

/// What a mesh brings: one element a vertex; values may be empty (then the colours show).
struct DrawnMesh {
  std::span<const Vec3f> positions;                              ///< m
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const float> values;
  std::span<const Rgb> colours;
};

/// Adds discs on both sides of the triangles, `fine` times `fine` a triangle, with normals that turn smoothly from vertex to vertex.
void addMeshDiscs(const DrawnMesh& mesh, int fine, FrameView& view);

/// Replaces a view's particles by balls of discs of this radius (m), each of one colour.
void ballsOfParticles(float radius, const Rgb& colour, FrameView& view);

}  // namespace thaw
