// SPDX-License-Identifier: Apache-2.0
#include "io/render/scene_marks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/basic/signed_distance.hpp"
#include "io/scene/scene_for_all.hpp"

namespace thaw {
namespace {

struct Axes {
  Vec3d u, v;
};

/// Returns two unit vectors across a direction, by the rule of planEmitters.
Axes across(const Vec3d& n) {
  const Vec3d axis = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? Vec3d{1, 0, 0}
                     : std::abs(n.y) <= std::abs(n.z)                                 ? Vec3d{0, 1, 0}
                                                                                      : Vec3d{0, 0, 1};
  const Vec3d u = normalized(axis - n * dot(axis, n));
  return {u, cross(n, u)};
}

void addLoop(Mark& mark, const std::vector<Vec3d>& corners) {
  for (std::size_t k = 0; k < corners.size(); k++)
    mark.lines.push_back({corners[k], corners[(k + 1) % corners.size()]});
}

void addArrow(Mark& mark, const Vec3d& from, const Vec3d& to) {
  const Vec3d along = to - from;
  const Axes side = across(normalized(along));
  mark.lines.push_back({from, to});
  for (const Vec3d& away : {side.u, side.v, -side.u, -side.v})
    mark.lines.push_back({to, to - 0.25 * along + (0.12 * length(along)) * away});
}

void addBox(Mark& mark, const Bounds& box) {
  const auto corner = [&](int k) {
    return Vec3d{k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z};
  };
  for (int k = 0; k < 8; k++)
    for (const int axis : {1, 2, 4})
      if (!(k & axis)) mark.lines.push_back({corner(k), corner(k | axis)});
}

Mark emitterMark(const Emitter& e) {
  Mark mark{MarkKind::Emitter, e.name, {}};
  const Vec3d n = normalized(e.direction);
  const auto [u, v] = across(n);
  std::vector<Vec3d> opening;
  constexpr int corners = 40;
  if (e.disc) {
    for (int k = 0; k < corners; k++) {
      const double angle = 2 * std::numbers::pi * k / corners;
      opening.push_back(e.centre + (e.radius * std::cos(angle)) * u + (e.radius * std::sin(angle)) * v);
    }
  } else {
    for (const auto& [a, b] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      opening.push_back(e.centre + (a * e.width) * u + (b * e.depth) * v);
  }
  addLoop(mark, opening);
  addArrow(mark, e.centre, e.centre + (e.disc ? 2.5 * e.radius : 1.2 * std::max(e.width, e.depth)) * n);
  return mark;
}

/// Returns the box of a clamp within its body, slightly enlarged. It has no lines if the two do not overlap.
Mark clampMark(const Scene& scene, const Body& body, const Shape& clamp) {
  Mark mark{MarkKind::Clamp, body.name, {}};
  Bounds box = makeSignedDistance(clamp, meshLoader())->bounds();
  const Bounds around = makeSignedDistance(body.shape, meshLoader())->bounds();
  const double margin = 0.2 * scene.spacing;
  for (int a = 0; a < 3; a++) {
    box.min[a] = std::max(box.min[a], around.min[a]) - margin;
    box.max[a] = std::min(box.max[a], around.max[a]) + margin;
    if (!std::isfinite(box.max[a] - box.min[a]) || box.max[a] < box.min[a]) return mark;
  }
  addBox(mark, box);
  return mark;
}

/// Returns a pyramid with the shape of the picture, a mark on its upper side, and the line of sight.
Mark cameraMark(const Camera& camera, double aspect) {
  Mark mark{MarkKind::Camera, "", {}};
  const Vec3d sight = camera.at - camera.from, forward = normalized(sight);
  const Vec3d level = cross(forward, Vec3d{0, 0, 1});
  const Vec3d right = length(level) > 0 ? normalized(level) : Vec3d{1, 0, 0}, up = cross(right, forward);
  const double depth = 0.2 * length(sight), tall = depth * std::tan(0.5 * camera.fieldOfView),
               wide = aspect * tall;
  const auto at = [&](double a, double b) {
    return camera.from + depth * forward + (a * wide) * right + (b * tall) * up;
  };
  const std::vector<Vec3d> corners{at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
  for (const Vec3d& corner : corners) mark.lines.push_back({camera.from, corner});
  addLoop(mark, corners);
  addLoop(mark, {at(-0.5, 1.15), at(0.5, 1.15), at(0, 1.7)});
  mark.lines.push_back({camera.from, camera.at});
  return mark;
}

}  // namespace

std::vector<Mark> sceneMarks(const Scene& scene) {
  std::vector<Mark> marks;
  for (const Emitter& e : scene.emitters) marks.push_back(emitterMark(e));
  for (const Body& body : scene.bodies)
    for (const Shape& clamp : body.clamp)
      if (Mark mark = clampMark(scene, body, clamp); !mark.lines.empty()) marks.push_back(std::move(mark));
  Mark domain{MarkKind::Domain, "", {}};
  addBox(domain, {scene.domain.min, scene.domain.max});
  marks.push_back(std::move(domain));
  const Output& o = scene.output;
  if (!o.camera.fitted) marks.push_back(cameraMark(o.camera, static_cast<double>(o.width) / o.height));
  return marks;
}

}  // namespace thaw
