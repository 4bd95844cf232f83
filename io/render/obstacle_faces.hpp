// SPDX-License-Identifier: Apache-2.0
// Solid obstacles in pictures: triangles that share light, shadow and depth with surfels.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"
#include "io/render/render_frames.hpp"

namespace thaw {

/// Returns the obstacles that look solid, with triangles small enough for their shadows, but no planes, which
/// are floors. Throws like makeSignedDistance.
std::vector<DrawnObstacle> solidObstacles(const Scene& scene);

/// Adds the places of the obstacles at their keyframes to a box.
void addToBox(const std::vector<DrawnObstacle>& obstacles, ViewBox& box);

/// Adds the obstacles that are present at the time of the view. Particles become balls of discs; radius (m):
/// of these.
void addObstacles(const std::vector<DrawnObstacle>& obstacles, float radius, FrameView& view);

}  // namespace thaw
