// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/marching/sharp_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/math/mat3.hpp"

namespace thaw {
namespace {

constexpr double smooth = 0.866;  // cosine of the largest angle between normals of a smooth surface
constexpr double nearEnd = 0.15;  // fraction of a side: a vertex this close to an edge moves onto it
constexpr double farthest = 1.5;  // spacings, largest distance from the middle of a side to its point on an
                                  // edge
constexpr int projections = 4;    // several, because distances of combined shapes are only bounds

/// Position (m) of a vertex, and outward normals of the faces on which it lies. There is one normal, two on
/// an edge of the shape, or three at a corner.
struct SurfacePoint {
  Vec3d x{};
  std::array<Vec3d, 3> normals{};
  std::size_t faces = 1;
};

SurfacePoint projected(Vec3d x, const SignedDistance& shape, double spacing) {
  Vec3d normal{};
  for (int k = 0; k < projections; k++) {
    const double away = shape.distanceWithin(x, 2 * spacing, &normal);
    x -= away * normal;
  }
  return {x, {normal}};
}

bool isSharp(const SurfacePoint& a, const SurfacePoint& b) {
  return a.faces == 1 && b.faces == 1 && dot(a.normals[0], b.normals[0]) < smooth;
}

/// Returns the point in the tangent planes of both points, on the edge, that is closest to their middle.
std::optional<SurfacePoint> edgePoint(const SurfacePoint& a, const SurfacePoint& b, double spacing) {
  const Vec3d &m = a.normals[0], &n = b.normals[0], middle = 0.5 * (a.x + b.x);
  const double c = dot(m, n), u = dot(m, a.x - middle), v = dot(n, b.x - middle), det = 1 - c * c;
  if (det < 1e-3) return std::nullopt;  // faces back to back
  const Vec3d offset = m * ((u - c * v) / det) + n * ((v - c * u) / det);
  if (length(offset) > farthest * spacing) return std::nullopt;
  return SurfacePoint{middle + offset, {m, n}, 2};
}

/// Plane through a point, with a normal.
struct Plane {
  Vec3d normal, x;
};

/// Returns the intersection of three planes, unless all are nearly parallel to one line.
std::optional<SurfacePoint> cornerPoint(const std::array<Plane, 3>& p, const Vec3d& middle, double spacing) {
  const Vec3d &a = p[0].normal, &b = p[1].normal, &c = p[2].normal;
  const double det = dot(a, cross(b, c));
  if (std::abs(det) < 0.1) return std::nullopt;
  const Vec3d offset = (cross(b, c) * dot(a, p[0].x - middle) + cross(c, a) * dot(b, p[1].x - middle) +
                        cross(a, b) * dot(c, p[2].x - middle)) *
                       (1 / det);
  if (length(offset) > farthest * spacing) return std::nullopt;
  return SurfacePoint{middle + offset, {a, b, c}, 3};
}

using MeshSide = std::pair<std::uint32_t, std::uint32_t>;

MeshSide sideOf(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Moves the closer end of each side onto the edge that the side crosses, if the distance is below a
/// fraction of the side.
void moveEnds(const TriangleMesh& mesh, std::vector<SurfacePoint>& points, double spacing, double fraction) {
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; k++) {
      SurfacePoint &a = points[t[k]], &b = points[t[(k + 1) % 3]];
      if (!isSharp(a, b)) continue;
      const std::optional<SurfacePoint> on = edgePoint(a, b, spacing);
      if (!on) continue;
      const double side = length(b.x - a.x), toA = length(on->x - a.x), toB = length(on->x - b.x);
      if (std::min(toA, toB) < fraction * side) (toA < toB ? a : b) = *on;
    }
}

/// For each triangle on three faces, moves the vertex closest to their corner to that corner.
void moveToCorners(const TriangleMesh& mesh, std::vector<SurfacePoint>& points, double spacing) {
  for (const auto& t : mesh.triangles) {
    std::array<Plane, 3> planes{};
    std::size_t known = 0, most = 0;
    for (const std::uint32_t v : t) {
      const SurfacePoint& p = points[v];
      most = std::max(most, p.faces);
      for (std::size_t k = 0; k < p.faces && known < 3; k++) {
        bool isNew = true;
        for (std::size_t i = 0; i < known; i++) isNew = isNew && dot(planes[i].normal, p.normals[k]) < smooth;
        if (isNew) planes[known++] = {p.normals[k], p.x};
      }
    }
    if (known < 3 || most == 3) continue;
    const Vec3d middle = (points[t[0]].x + points[t[1]].x + points[t[2]].x) * (1.0 / 3);
    const std::optional<SurfacePoint> corner = cornerPoint(planes, middle, spacing);
    if (!corner) continue;
    const auto to = [&](std::uint32_t v) { return length(points[v].x - corner->x); };
    const std::uint32_t first = to(t[0]) < to(t[1]) ? t[0] : t[1],
                        nearest = to(first) < to(t[2]) ? first : t[2];
    points[nearest] = *corner;
  }
}

/// Returns new vertices on the sides that cross an edge of the shape, and adds the vertices to the points.
std::map<MeshSide, std::uint32_t> divideSides(const TriangleMesh& mesh, std::vector<SurfacePoint>& points,
                                              double spacing) {
  std::map<MeshSide, std::uint32_t> vertex;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; k++) {
      const MeshSide side = sideOf(t[k], t[(k + 1) % 3]);
      if (vertex.contains(side) || !isSharp(points[side.first], points[side.second])) continue;
      const std::optional<SurfacePoint> on = edgePoint(points[side.first], points[side.second], spacing);
      if (!on) continue;
      vertex[side] = static_cast<std::uint32_t>(points.size());
      points.push_back(*on);
    }
  return vertex;
}

/// Adds the parts of a triangle whose sides 0 (corners 0 and 1), 1 and 2 have these vertices.
void addDivided(const std::array<std::uint32_t, 3>& t, const std::array<std::optional<std::uint32_t>, 3>& on,
                std::vector<SurfacePoint>& points, double spacing,
                std::vector<std::array<std::uint32_t, 3>>& out) {
  const int divided = on[0].has_value() + on[1].has_value() + on[2].has_value();
  if (divided == 0) return out.push_back(t);
  if (divided == 3) {
    const Vec3d sides = (points[*on[0]].x + points[*on[1]].x + points[*on[2]].x) * (1.0 / 3);
    std::array<Plane, 3> planes{};
    for (std::size_t k = 0; k < 3; k++) planes[k] = {points[t[k]].normals[0], points[t[k]].x};
    const auto middle = static_cast<std::uint32_t>(points.size());
    points.push_back(cornerPoint(planes, sides, spacing).value_or(SurfacePoint{sides, {}, 3}));
    for (std::size_t k = 0; k < 3; k++) {
      out.push_back({t[k], *on[k], middle});
      out.push_back({*on[k], t[(k + 1) % 3], middle});
    }
    return;
  }
  std::size_t k = 0;  // two divided sides: the corner between them; one: the start of that side
  while (divided == 2 ? !(on[(k + 2) % 3] && on[k]) : !on[k]) k++;
  const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], p = *on[k];
  if (divided == 1) {
    out.push_back({a, p, c});
    return out.push_back({p, b, c});
  }
  const std::uint32_t q = *on[(k + 2) % 3];
  out.push_back({a, p, q});
  if (length(points[p].x - points[c].x) < length(points[q].x - points[b].x)) {
    out.push_back({p, b, c});
    out.push_back({p, c, q});
  } else {
    out.push_back({p, b, q});
    out.push_back({q, b, c});
  }
}

}  // namespace

namespace {

std::vector<SurfacePoint> projectedVertices(const TriangleMesh& mesh, const SignedDistance& shape,
                                            double spacing) {
  std::vector<SurfacePoint> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3d& x : mesh.vertices) points.push_back(projected(x, shape, spacing));
  return points;
}

}  // namespace

TriangleMesh withSharpEdges(const TriangleMesh& mesh, const SignedDistance& shape, double spacing) {
  std::vector<SurfacePoint> points = projectedVertices(mesh, shape, spacing);
  moveEnds(mesh, points, spacing, nearEnd);
  const std::map<MeshSide, std::uint32_t> divided = divideSides(mesh, points, spacing);
  const auto on = [&](std::uint32_t a, std::uint32_t b) -> std::optional<std::uint32_t> {
    const auto found = divided.find(sideOf(a, b));
    return found == divided.end() ? std::nullopt : std::optional(found->second);
  };
  TriangleMesh out;
  for (const auto& t : mesh.triangles)
    addDivided(t, {on(t[0], t[1]), on(t[1], t[2]), on(t[2], t[0])}, points, spacing, out.triangles);
  moveToCorners(out, points, spacing);
  for (const SurfacePoint& p : points) out.vertices.push_back(p.x);
  return out;
}

std::vector<std::uint8_t> moveOntoEdges(TriangleMesh& mesh, const SignedDistance& shape, double spacing) {
  std::vector<SurfacePoint> points = projectedVertices(mesh, shape, spacing);
  moveEnds(mesh, points, spacing, 1);
  moveToCorners(mesh, points, spacing);
  std::vector<std::uint8_t> onEdge;
  for (std::size_t k = 0; k < points.size(); k++) {
    mesh.vertices[k] = points[k].x;
    onEdge.push_back(static_cast<std::uint8_t>(points[k].faces - 1));
  }
  return onEdge;
}

}  // namespace thaw
