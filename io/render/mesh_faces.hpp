// SPDX-License-Identifier: Apache-2.0
// Triangles in a view of surfels: sheets and triangulated oriented bodies share light, shadow and depth with
// surfels, without gaps at folds.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/render/render_frames.hpp"

namespace thaw {

/// Mesh data, one element per vertex. If values are empty, colours are used.
struct DrawnMesh {
  std::span<const Vec3f> positions;  ///< m
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const float> values;
  std::span<const Rgb> colours;
};

/// Extends the arrays of a view of surfels, so that rows with all attributes can be added.
void extendArrays(FrameView& view);

/// Adds both sides of a mesh with interpolated vertex normals.
void addMeshFaces(const DrawnMesh& mesh, FrameView& view);

/// Corner of a triangle with its shading data.
struct FaceCorner {
  Vec3f place, normal;
  Rgb colour, back;  ///< colours of the side of the normal and of the other side
};

/// Adds both sides of one triangle with its own corner normals, independent of its neighbours.
void addFace(const std::array<FaceCorner, 3>& corners, FrameView& view);

}  // namespace thaw
