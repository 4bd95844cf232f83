// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/element_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

constexpr double facing = 0.7;  // cosine between the normals of two planes that touch

/// Returns true if the point of the element in this direction lies on its part of the surface.
bool reaches(const PlacedElement& e, const Vec3d& direction, double spacing) {
  if (e.round()) return true;
  const double cosine = dot(e.normal, direction);
  if (!(cosine > 0)) return false;
  return e.plane() || e.radius * length(direction - cosine * e.normal) <= sphereReach * spacing;
}

/// Distance (m) of the surface from the particle along a direction.
double extentAlong(const PlacedElement& e, const Vec3d& direction) {
  if (e.round() || e.plane()) return e.offset;
  return e.radius + (e.offset - e.radius) * dot(e.normal, direction);
}

std::optional<Vec3d> commonNormal(const PlacedElement& a, const PlacedElement& b) {
  if (a.plane() && b.plane()) {
    if (dot(a.normal, b.normal) > -facing) return {};
    return normalized(b.normal - a.normal);
  }
  if (a.plane()) return -a.normal;
  if (b.plane()) return b.normal;
  const Vec3d line = a.centre() - b.centre();
  const double size = length(line);
  if (!(size > 0)) return {};
  return line / size;
}

/// Distance (m) along a plane element from its particle to a point.
double asideOf(const PlacedElement& plane, const Vec3d& point) {
  const Vec3d to = point - plane.position;
  return length(to - dot(to, plane.normal) * plane.normal);
}

}  // namespace

std::optional<ElementContact> contactOf(const PlacedElement& a, const PlacedElement& b, double spacing) {
  const std::optional<Vec3d> n = commonNormal(a, b);
  if (!n || !reaches(a, -*n, spacing) || !reaches(b, *n, spacing)) return {};
  const Vec3d to = a.position - b.position;
  const double height = dot(to, *n), sa = extentAlong(a, -*n), sb = extentAlong(b, *n);
  if (!(height > -spacing)) return {};  // the two are back to back
  ElementContact c{{}, *n, height - sa - sb, length(to - height * *n)};
  // surface points of spheres; on planes the point opposite
  const Vec3d pa = a.plane() ? a.position - sa * *n : a.centre() - a.radius * *n;
  const Vec3d pb = b.plane() ? b.position + sb * *n : b.centre() + b.radius * *n;
  const Vec3d middle = a.plane() == b.plane() ? 0.5 * (pa + pb) : a.plane() ? pb : pa;
  const double between = a.plane() == b.plane() ? 0 : (a.plane() ? 0.5 : -0.5) * c.gap;
  c.point = middle + between * *n;
  if (a.plane() && b.plane()) return c.aside <= elementReach * spacing ? std::optional(c) : std::nullopt;
  if (!a.plane() && !b.plane()) return c;
  c.aside = asideOf(a.plane() ? a : b, c.point);
  return c.aside <= planeReach * spacing ? std::optional(c) : std::nullopt;
}

PlacedElement placedElement(const SurfaceElement& e, const Vec3d& position, const Quat& orientation) {
  const Vec3d n = rotated(orientation, wide(e.normal));
  const double offset = e.offset;
  if (e.radius > e.offset) return {position, n, offset, static_cast<double>(e.radius), {}};
  return {position, {}, offset, offset, offset * n};
}

std::optional<OutermostPoint> outermost(const PlacedElement& e, const Vec3d& direction, double spacing) {
  // The edge replaces the sphere slightly beyond its cone of normals, where faces lie further out.
  constexpr double cone = 0.9;
  const auto fixed = [](const Vec3d& x) { return OutermostPoint{x, x, false}; };
  if (e.round()) {
    if (dot(e.corner, direction) > cone * e.offset) return fixed(e.position + e.corner);
    return OutermostPoint{e.position + e.offset * direction, e.position, false};
  }
  const double cosine = dot(e.normal, direction);
  if (!(cosine > 0)) return {};
  if (e.plane()) {
    if (cosine > facing) return fixed(e.position + e.offset * e.normal);
    return {};
  }
  const Vec3d along = direction - cosine * e.normal;
  const double sine = length(along), most = sphereReach * spacing / e.radius;
  if (sine <= most) return OutermostPoint{e.centre() + e.radius * direction, e.centre(), false};
  if (cosine < facing) return {};
  const Vec3d towards = std::sqrt(std::max(0.0, 1 - most * most)) * e.normal + (most / sine) * along;
  OutermostPoint rim = fixed(e.centre() + e.radius * towards);
  rim.atRim = true;
  return rim;
}

}  // namespace thaw
