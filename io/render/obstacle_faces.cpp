// SPDX-License-Identifier: Apache-2.0
#include "io/render/obstacle_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

/// Adds triangles whose corners share vertices.
void addShared(const std::vector<std::array<Corner, 3>>& triangles, DrawnObstacle& drawn) {
  std::map<std::array<double, 6>, std::uint32_t> numbers;
  for (const auto& t : triangles) {
    std::array<std::uint32_t, 3> rows;
    for (std::size_t k = 0; k < 3; k++) {
      const Vec3d &x = t[k].place, &n = t[k].normal;
      const auto [at, isNew] = numbers.try_emplace({x.x, x.y, x.z, n.x, n.y, n.z},
                                                   static_cast<std::uint32_t>(drawn.places.size()));
      if (isNew) drawn.places.push_back(x), drawn.normals.push_back(n), drawn.radii.push_back(0);
      rows[k] = at->second;
      const auto edge = static_cast<float>(0.6 * length(t[(k + 1) % 3].place - x));
      drawn.radii[rows[k]] = std::max(drawn.radii[rows[k]], edge);
    }
    drawn.triangles.push_back(rows);
  }
}

/// Adds an obstacle at its pose. Its inner side is never seen.
void addObstacle(const DrawnObstacle& o, const Pose& pose, FrameView& view) {
  constexpr std::uint32_t component = 0xfffffff0u;
  const auto first = static_cast<std::uint32_t>(view.positions.size());
  for (std::size_t k = 0; k < o.places.size(); k++) {
    view.positions.push_back(single(fromRest(pose, o.places[k])));
    view.normals.push_back(single(directionFromRest(pose, o.normals[k])));
  }
  view.radii.insert(view.radii.end(), o.radii.begin(), o.radii.end());
  view.values.resize(view.positions.size(), std::numeric_limits<float>::quiet_NaN());
  view.colours.resize(view.positions.size(), o.colour);
  view.components.resize(view.positions.size(), component);
  for (const auto& t : o.triangles) view.faces.push_back({first + t[0], first + t[1], first + t[2]});
  for (const auto& t : o.casters)
    view.solids.push_back(
        {single(fromRest(pose, t[0])), single(fromRest(pose, t[1])), single(fromRest(pose, t[2]))});
  view.solidFaces += o.triangles.size();
}

/// Adds points at all keyframes of their motion.
void addMoving(const std::vector<Vec3d>& points, const std::vector<Keyframe>& motion, ViewBox& box) {
  std::vector<Pose> poses{poseAt(motion, 0)};
  for (const Keyframe& key : motion) poses.push_back(poseAt(motion, key.time));
  for (const Pose& pose : poses)
    for (const Vec3d& x : points) box.add(fromRest(pose, x));
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
    DrawnObstacle drawn{{}, {}, {}, {}, {}, obstacle.motion, obstacle.until, rgbOf(obstacle.colour)};
    for (const auto& t : made.mesh.triangles)
      drawn.casters.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
    addShared(triangles, drawn);
    all.push_back(std::move(drawn));
  }
  return all;
}

void addToBox(const std::vector<DrawnObstacle>& obstacles, ViewBox& box) {
  for (const DrawnObstacle& o : obstacles) addMoving(o.places, o.motion, box);
}

void addGlassToBox(const Walls& walls, ViewBox& box) {
  for (const Wall& wall : walls.list) {
    const Bounds b = wall.shape->bounds();
    const bool bounded = std::isfinite(length(b.max - b.min));
    if (!bounded || wall.isImage() || wall.properties.look != ObstacleLook::Glass) continue;
    std::vector<Vec3d> corners;
    for (int k = 0; k < 8; k++)
      corners.push_back({k & 1 ? b.max.x : b.min.x, k & 2 ? b.max.y : b.min.y, k & 4 ? b.max.z : b.min.z});
    addMoving(corners, wall.properties.motion, box);
  }
}

void addObstacles(const std::vector<DrawnObstacle>& obstacles, float radius, FrameView& view) {
  makeDiscs(radius, view);
  for (const DrawnObstacle& o : obstacles)
    if (view.time < o.until) addObstacle(o, poseAt(o.motion, view.time), view);
}

}  // namespace thaw
