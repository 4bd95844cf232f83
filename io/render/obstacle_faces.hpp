// SPDX-License-Identifier: Apache-2.0
// Solid obstacles in pictures: triangles that share light, shadow and depth with surfels.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/walls/walls.hpp"
#include "io/render/render_frames.hpp"

namespace thaw {

/// An obstacle drawn as a solid, at rest. Each vertex has one normal, so both sides of an edge have
/// vertices of their own.
struct DrawnObstacle {
  std::vector<Vec3d> places, normals;  ///< m; unit, outward
  std::vector<float> radii;            ///< m, a fraction of the longest edge, for light queries
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< small enough for the shadows on them
  std::vector<std::array<Vec3d, 3>> casters;            ///< m, the same surface in fewer triangles
  std::vector<Keyframe> motion;
  double until = never;  ///< s
  Rgb colour;
};

/// Returns the obstacles that look solid, with triangles small enough for their shadows. Omits planes, which
/// are floors, and periodic images. Throws like makeSignedDistance.
std::vector<DrawnObstacle> solidObstacles(const Walls& walls);

/// Adds the obstacles in their poses at keyframes to a box.
void addToBox(const std::vector<DrawnObstacle>& obstacles, ViewBox& box);
/// Adds the boxes of bounded glass obstacles at their keyframes, whose shadows the floor shows.
void addGlassToBox(const Walls& walls, ViewBox& box);

/// Adds the obstacles that are present at the time of the view. Particles become balls of
/// discs of this radius (m).
void addObstacles(const std::vector<DrawnObstacle>& obstacles, float radius, FrameView& view);

}  // namespace thaw
