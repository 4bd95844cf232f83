// SPDX-License-Identifier: Apache-2.0
// Camera position and projection.
#pragma once
#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Axis-aligned box around particles; empty (min > max) at first.
struct ViewBox {
  Vec3d min{1e300, 1e300, 1e300}, max{-1e300, -1e300, -1e300};  // m
  void add(const Vec3d& p);
  bool empty() const { return min.x > max.x; }
  Vec3d centre() const { return 0.5 * (min + max); }
};

/// Perspective camera with z up. Pixels count from the upper left corner.
struct View {
  Vec3f origin, right, up, forward;           // m; unit vectors
  float focal = 1, centreX = 0, centreY = 0;  // pixels

  /// Returns the distance along the view direction, and x and y in pixels if it is positive.
  float project(const Vec3f& p, float& x, float& y) const {
    const Vec3f d = p - origin;
    const float z = dot(forward, d), scale = focal / z;
    x = centreX + scale * dot(right, d);
    y = centreY - scale * dot(up, d);
    return z;
  }
  /// Returns the direction (not normalised, of depth 1) of the ray through a point of the picture.
  Vec3f ray(float x, float y) const {
    return forward + ((x - centreX) / focal) * right + ((centreY - y) / focal) * up;
  }
};

/// Returns the view of the scene's camera on a picture of width x height pixels.
View viewOf(const Camera& camera, int width, int height);

/// Returns a camera in front (against y), to the right and above. It fits the box into the picture (aspect:
/// width over height) with a margin.
Camera fittedCamera(const ViewBox& bounds, double aspect);

}  // namespace thaw
