// SPDX-License-Identifier: Apache-2.0
#include "io/render/obstacle_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/shapes/pose.hpp"
#include "io/render/mesh_faces.hpp"
#include "io/render/oriented_view.hpp"
#include "io/surface_mesh/obstacle_mesh.hpp"

namespace thaw {

namespace {

constexpr double edgesAcross = 40;  // triangles along the longest side of an obstacle

struct Corner {
  Vec3d place, normal;
};

Corner middle(const Corner& a, const Corner& b) {
  return {0.5 * (a.place + b.place), normalized(a.normal + b.normal)};
}

/// Halves the longest edge until none is longer than `most` (m). Both triangles at an edge halve it at the
/// same point.
void divide(const std::array<Corner, 3>& t, double most, std::vector<std::array<Corner, 3>>& out) {
  std::size_t longest = 0;
  double length2[3];
  for (std::size_t k = 0; k < 3; k++) {
    const Vec3d edge = t[(k + 1) % 3].place - t[k].place;
    length2[k] = dot(edge, edge);
    if (length2[k] > length2[longest]) longest = k;
  }
  if (length2[longest] <= most * most) {
    out.push_back(t);
    return;
  }
  const Corner &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3], half = middle(a, b);
  divide({a, half, c}, most, out);
  divide({half, b, c}, most, out);
}

bool drawnSolid(const Wall& wall) {
  const bool plane = !std::isfinite(length(wall.bounds.max - wall.bounds.min));
  return wall.properties.look == ObstacleLook::Solid && !plane && !wall.isImage();
}

/// Makes a view of surfels of one of particles.
void makeDiscs(float radius, FrameView& view) {
  if (view.normals.empty() && !view.positions.empty()) spheresToDiscs(view, radius);
  extendArrays(view);
  if (view.paint == SurfelPaint::Plain) view.paint = SurfelPaint::Surface;
  if (view.paint == SurfelPaint::Values) view.paint = SurfelPaint::Mixed;
}

}  // namespace

std::vector<DrawnObstacle> solidObstacles(const Walls& walls) {
  std::vector<DrawnObstacle> all;
  for (const Wall& wall : walls.list) {
    if (!drawnSolid(wall)) continue;
    const Obstacle& obstacle = wall.properties;
    const ComponentMesh made = obstacleMesh(obstacle, {});
    const std::vector<Vec3d>& vertices = made.mesh.vertices;
    ViewBox box;
    for (const Vec3d& x : vertices) box.add(x);
    const Vec3d size = box.max - box.min;
    const double most = std::max({size.x, size.y, size.z}) / edgesAcross;
    std::vector<std::array<Corner, 3>> triangles;
    for (const auto& t : made.mesh.triangles) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; k++) {
        const Vec3f& n = made.normals[t[k]];
        corners[k] = {vertices[t[k]], {n.x, n.y, n.z}};
      }
      divide(corners, most, triangles);
    }
    DrawnObstacle drawn{{}, {}, obstacle.motion, obstacle.until, rgbOf(obstacle.colour)};
    for (const auto& t : triangles)
      for (const Corner& corner : t) {
        drawn.places.push_back(corner.place);
        drawn.normals.push_back(corner.normal);
      }
    all.push_back(std::move(drawn));
  }
  return all;
}

void addToBox(const std::vector<DrawnObstacle>& obstacles, ViewBox& box) {
  for (const DrawnObstacle& o : obstacles) {
    std::vector<Pose> poses{poseAt(o.motion, 0)};
    for (const Keyframe& key : o.motion) poses.push_back(poseAt(o.motion, key.time));
    for (const Pose& pose : poses)
      for (const Vec3d& x : o.places) box.add(fromRest(pose, x));
  }
}

void addObstacles(const std::vector<DrawnObstacle>& obstacles, float radius, FrameView& view) {
  makeDiscs(radius, view);
  for (const DrawnObstacle& o : obstacles) {
    if (view.time >= o.until) continue;
    const Pose pose = poseAt(o.motion, view.time);
    for (std::size_t k = 0; k + 2 < o.places.size(); k += 3) {
      std::array<FaceCorner, 3> corners;
      for (std::size_t c = 0; c < 3; c++)
        corners[c] = {single(fromRest(pose, o.places[k + c])),
                      single(directionFromRest(pose, o.normals[k + c])), o.colour, o.colour};
      addFace(corners, view);
    }
  }
}

}  // namespace thaw
