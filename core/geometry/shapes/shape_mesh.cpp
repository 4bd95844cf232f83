// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/shape_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/marching/polygonise.hpp"
#include "core/geometry/shapes/combined.hpp"
#include "core/geometry/shapes/placed_mesh.hpp"

namespace thaw {
namespace {

using std::numbers::pi;
using Outline = std::vector<RevolvedDistance::Point>;

/// Region (m) in which planes are shown.
struct Ball {
  Vec3d centre{};
  double radius = 0;
};

/// Returns the number of steps around a circle with chords within `sag` of it.
int stepsAround(double radius, double sag) {
  constexpr int least = 24, most = 4096;
  const double step = 2 * std::acos(std::clamp(1 - sag / radius, -1.0, 1.0));
  return static_cast<int>(
      std::clamp(std::ceil(2 * pi / step), static_cast<double>(least), static_cast<double>(most)));
}

/// Returns n pieces of a circle in the half-plane between two angles, ends included.
Outline arc(double middle, double radius, double from, double to, int n) {
  Outline o;
  for (int k = 0; k <= n; k++) {
    const double a = from + (to - from) * k / n;
    o.push_back({middle + radius * std::cos(a), radius * std::sin(a)});
  }
  return o;
}

TriangleMesh boxOf(const Vec3d& size) {
  TriangleMesh m;
  for (int k = 0; k < 8; k++)
    m.vertices.push_back(
        {(k & 1 ? 0.5 : -0.5) * size.x, (k & 2 ? 0.5 : -0.5) * size.y, (k & 4 ? 0.5 : -0.5) * size.z});
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

TriangleMesh squareOf(const Shape& s, const Ball& seen) {
  const Vec3d n = normalized(s.normal), middle = seen.centre - dot(seen.centre - s.point, n) * n;
  const Vec3d u = normalized(cross(n, std::abs(n.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0})) *
                  (1.5 * seen.radius),
              v = cross(n, u);
  return {{middle - u - v, middle + u - v, middle + u + v, middle - u + v}, {{0, 1, 2}, {0, 2, 3}}};
}

/// Returns triangles of an extension's shape. The smallest resolved radius is twice a cube's edge. On this
/// radius, a chord of one edge deviates from the surface by at most `sag` (m).
TriangleMesh extensionMesh(const Shape& s, double sag) {
  constexpr double most = 160;  // cubes along the longest edge
  const std::shared_ptr<const SignedDistance> shape = makeSignedDistance(s);
  Bounds b = shape->bounds();
  const Vec3d size = b.max - b.min;
  if (!std::isfinite(size.x + size.y + size.z))
    throw std::invalid_argument("the shape '" + s.extension.name + "' is infinite: it has no mesh");
  const double edge = std::max({16 * sag, size.x / most, size.y / most, size.z / most});
  b.min -= Vec3d{edge, edge, edge}, b.max += Vec3d{edge, edge, edge};
  return polygonise([&](const Vec3d& x) { return shape->distance(x); }, b, edge);
}

TriangleMesh placedParts(const Shape& s, double sag, const Ball& seen, const MeshLoader& load);

TriangleMesh unplaced(const Shape& s, double sag, const Ball& seen, const MeshLoader& load) {
  switch (s.kind) {
    case ShapeKind::Box: return boxOf(s.size);
    case ShapeKind::Sphere: {
      const int n = stepsAround(s.radius, sag), half = (n + 1) / 2;
      Outline o = arc(0, s.radius, -0.5 * pi, 0.5 * pi, half);
      o.front() = {0, -s.radius}, o.back() = {0, s.radius};  // exactly on the axis
      return revolvedMesh(o, false, n);
    }
    case ShapeKind::Cylinder:
      return revolvedMesh(cylinderOutline(s.radius, s.height), false, stepsAround(s.radius, sag));
    case ShapeKind::Torus: {
      Outline o = arc(s.radius, s.radius2, 0, 2 * pi, stepsAround(s.radius2, sag));
      o.pop_back();
      for (RevolvedDistance::Point& p : o) p.r = std::max(p.r, 0.0);  // for a tube thicker than its ring
      return revolvedMesh(o, true, stepsAround(s.radius + s.radius2, sag));
    }
    case ShapeKind::Glass:
      return revolvedMesh(glassOutline(s.radius, s.height, s.thickness), false, stepsAround(s.radius, sag));
    case ShapeKind::HalfSpace: return squareOf(s, seen);
    case ShapeKind::Mesh: return makePlacedMesh(s, load).mesh;
    case ShapeKind::Extension: return extensionMesh(s, sag);
    case ShapeKind::Union:
    case ShapeKind::Difference:
    case ShapeKind::Intersection: break;
  }
  TriangleMesh all;
  for (std::size_t k = 0; k < s.parts.size(); k++)
    appendTriangles(all, placedParts(s.parts[k], sag, seen, load), s.kind == ShapeKind::Difference && k > 0);
  return all;
}

TriangleMesh placedParts(const Shape& s, double sag, const Ball& seen, const MeshLoader& load) {
  const Shape atOrigin = withoutPlacement(s);
  const Placement p = placementOf(s, makeSignedDistance(atOrigin, load));
  const Ball there{transpose(p.rotation) * (seen.centre - p.move) / p.scale, seen.radius / p.scale};
  TriangleMesh m = unplaced(atOrigin, sag / p.scale, there, load);
  for (Vec3d& v : m.vertices) v = p.move + p.rotation * (p.scale * v);
  return m;
}

}  // namespace

void appendTriangles(TriangleMesh& to, const TriangleMesh& m, bool turned) {
  const auto first = static_cast<std::uint32_t>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), m.vertices.begin(), m.vertices.end());
  for (auto t : m.triangles) {
    if (turned) std::swap(t[1], t[2]);
    to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

Shape withoutPlacement(Shape s) {
  s.scale = 1;
  s.rotate = s.move = {};
  s.fitHeight.reset();
  s.bottom.reset();
  return s;
}

TriangleMesh revolvedMesh(const Outline& outline, bool closed, int around) {
  TriangleMesh m;
  std::vector<std::uint32_t> first;
  for (const RevolvedDistance::Point& p : outline) {
    first.push_back(static_cast<std::uint32_t>(m.vertices.size()));
    if (p.r == 0) {
      m.vertices.push_back({0, 0, p.z});
      continue;
    }
    for (int k = 0; k < around; k++)
      m.vertices.push_back({p.r * std::cos(2 * pi * k / around), p.r * std::sin(2 * pi * k / around), p.z});
  }
  for (std::size_t a = 0; a + (closed ? 0 : 1) < outline.size(); a++) {
    const std::size_t b = (a + 1) % outline.size();
    const auto at = [&](std::size_t point, int k) {
      return first[point] + (outline[point].r == 0 ? 0 : static_cast<std::uint32_t>(k % around));
    };
    for (int k = 0; k < around; k++) {
      if (outline[a].r != 0) m.triangles.push_back({at(a, k), at(a, k + 1), at(b, k)});
      if (outline[b].r != 0) m.triangles.push_back({at(a, k + 1), at(b, k + 1), at(b, k)});
    }
  }
  return m;
}

TriangleMesh shapeMesh(const Shape& s, double sag, const MeshLoader& load) {
  const Bounds b = makeSignedDistance(s, load)->bounds();
  const Vec3d size = b.max - b.min;
  if (!std::isfinite(size.x + size.y + size.z))
    throw ShapeError("the shape is not bounded on all sides and has no closed mesh; intersect it with a box",
                     s.where);
  return placedParts(s, sag, {0.5 * (b.min + b.max), 0.5 * length(size)}, load);
}

}  // namespace thaw
