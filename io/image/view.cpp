// SPDX-License-Identifier: Apache-2.0
#include "io/image/view.hpp"

#include <algorithm>

namespace thaw {

namespace {

struct Axes {
  Vec3d right, up, forward;
};
Axes axesOf(const Vec3d& direction) {
  const Vec3d forward = normalized(direction);
  // Straight down or up: y is up in the picture.
  const Vec3d pole = std::abs(forward.z) > 0.9999 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
  const Vec3d right = normalized(cross(forward, pole));
  return {right, cross(right, forward), forward};
}

}  // namespace

void ViewBox::add(const Vec3d& p) {
  for (int a = 0; a < 3; a++) {
    min[a] = std::min(min[a], p[a]);
    max[a] = std::max(max[a], p[a]);
  }
}

View viewOf(const Camera& camera, int width, int height) {
  const Axes axes = axesOf(camera.at == camera.from ? Vec3d{0, 1, 0} : camera.at - camera.from);
  View v;
  v.origin = single(camera.from);
  v.right = single(axes.right);
  v.up = single(axes.up);
  v.forward = single(axes.forward);
  v.focal = static_cast<float>(0.5 * height / std::tan(0.5 * camera.fieldOfView));
  v.centreX = 0.5f * static_cast<float>(width);
  v.centreY = 0.5f * static_cast<float>(height);
  return v;
}

Camera fittedCamera(const ViewBox& bounds, double aspect) {
  Camera camera;
  camera.fitted = true;
  camera.fieldOfView = 0.5;
  camera.at = bounds.empty() ? Vec3d{} : bounds.centre();
  const Axes axes = axesOf({-0.45, 1, -0.38});
  // Each corner c requires |x| <= tan_x (d + z) and |y| <= tan_y (d + z), with x, y, z along the camera's
  // axes.
  const double margin = 0.92, tanY = margin * std::tan(0.5 * camera.fieldOfView), tanX = tanY * aspect;
  double distance = 0;
  for (int corner = 0; corner < 8 && !bounds.empty(); corner++) {
    const Vec3d half = 0.5 * (bounds.max - bounds.min);
    const Vec3d c{corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
                  corner & 4 ? half.z : -half.z};
    const double z = dot(c, axes.forward);
    distance = std::max(
        {distance, std::abs(dot(c, axes.right)) / tanX - z, std::abs(dot(c, axes.up)) / tanY - z});
  }
  camera.from = camera.at - (distance > 0 ? distance : 1.0) * axes.forward;
  return camera;
}

}  // namespace thaw
