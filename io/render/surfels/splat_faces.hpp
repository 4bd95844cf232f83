// SPDX-License-Identifier: Apache-2.0
// Triangles on the samples of a tile of splatted surfels.
#pragma once
#include "io/render/surfels/splat_surfels.hpp"

namespace thaw {

/// Triangles that face the camera, in camera axes (right, up, forward), and the samples that they may cover.
struct CameraFaces {
  struct Face {
    std::array<Vec3f, 3> corner;
    Vec3f normal;                        ///< not normalised
    std::array<std::uint32_t, 3> shade;  ///< indices of the corners' shades
    int x0, x1, y0, y1;
  };
  std::vector<Face> faces;
};

/// Returns the `faces` (rows of positions) that face the camera, lie in the picture, and are not nearer than
/// `near`.
CameraFaces facesBefore(std::span<const Vec3f> positions, std::span<const std::array<std::uint32_t, 3>> faces,
                        const SampleGrid& samples, float near);

/// Draws these faces where they are nearer than the tile's depth, and sets drawn[sample] to 1 there.
void drawFaces(const CameraFaces& all, std::span<const std::uint32_t> which,
               std::span<const SurfelShade> shades, const View& view, SurfelTile& tile,
               std::vector<std::uint8_t>& drawn);

}  // namespace thaw
