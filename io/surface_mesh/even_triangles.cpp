// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/even_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/geometry/meshes/weld_vertices.hpp"
#include "core/geometry/shapes/combined.hpp"
#include "core/geometry/shapes/shape_mesh.hpp"
#include "io/surface_mesh/triangle_angles.hpp"

namespace thaw {
namespace {

using std::numbers::pi;
using Outline = std::vector<RevolvedDistance::Point>;

constexpr double longest = 3.4;  // sides of a rectangle whose halves have angles above 16 degrees
constexpr int mostCells = 150;   // along an edge

/// Returns the number of cells along an edge next to edges with this shortest length.
int cellsAlong(double length, double shortest) {
  return static_cast<int>(std::clamp(std::ceil(length / (longest * shortest)), 1.0, 1.0 * mostCells));
}

/// Adds the grid of a rectangle, counter-clockwise from u to v.
void addGrid(const Vec3d& corner, const Vec3d& u, const Vec3d& v, std::array<int, 2> cells,
             TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const int columns = cells[0], rows = cells[1];
  for (int j = 0; j <= rows; j++)
    for (int i = 0; i <= columns; i++)
      mesh.vertices.push_back(corner + (1.0 * i / columns) * u + (1.0 * j / rows) * v);
  const auto at = [&](int i, int j) { return first + static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; j++)
    for (int i = 0; i < columns; i++) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
}

/// Merges the vertices of separate faces. size: m, of the shape.
TriangleMesh joined(const TriangleMesh& faces, double size) { return weldVertices(faces, 1e-9 * size); }

TriangleMesh boxOf(const Vec3d& size) {
  const double shortest = std::min({size.x, size.y, size.z});
  TriangleMesh faces;
  for (int a = 0; a < 3; a++) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    Vec3d u{}, v{}, w{};
    u[b] = size[b], v[c] = size[c], w[a] = size[a];
    const int nu = cellsAlong(size[b], shortest), nv = cellsAlong(size[c], shortest);
    addGrid(0.5 * (w - u - v), u, v, {nu, nv}, faces);
    addGrid(-0.5 * (w + u + v), v, u, {nv, nu}, faces);
  }
  return joined(faces, length(size));
}

/// Returns a ball as an icosahedron whose faces are divided. Edges of length e are e^2 / (6 r) off the ball.
TriangleMesh ballOf(double radius, double sag) {
  const double edge = std::sqrt(6 * sag / radius), wide = 1.25 * 1.107;  // rad, of edges in the middle
  const int n = static_cast<int>(std::clamp(std::ceil(wide / edge), 1.0, 1.0 * mostCells));
  const double g = std::numbers::phi;
  const std::array<Vec3d, 12> corners{Vec3d{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                      {0, -1, g},      {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                      {g, 0, -1},      {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::array<std::array<int, 3>, 20> sides{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  TriangleMesh faces;
  for (const auto& side : sides) {
    const auto at = [&](int k) {
      return corners[static_cast<std::size_t>(side[static_cast<std::size_t>(k)])];
    };
    const Vec3d a = at(0), u = (1.0 / n) * (at(1) - a), v = (1.0 / n) * (at(2) - a);
    std::uint32_t first = static_cast<std::uint32_t>(faces.vertices.size());
    for (int j = 0; j <= n; j++)
      for (int i = 0; i <= n - j; i++)
        faces.vertices.push_back(radius * normalized(a + (1.0 * i) * u + (1.0 * j) * v));
    for (int j = 0; j < n; j++) {
      const std::uint32_t next = first + static_cast<std::uint32_t>(n - j + 1);
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n - j); i++) {
        faces.triangles.push_back({first + i, first + i + 1, next + i});
        if (i > 0) faces.triangles.push_back({first + i, next + i, next + i - 1});
      }
      first = next;
    }
  }
  return joined(faces, radius);
}

/// Rings of vertices around z. The vertices of a ring are evenly spaced.
class Rings {
 public:
  explicit Rings(int around) : around_(around) {}

  /// Adds the surface between two points of an outline. The solid is on its left.
  void add(const RevolvedDistance::Point& a, const RevolvedDistance::Point& b) {
    if (a.r == 0 && b.r == 0) return;
    if (a.r == 0) cap(b, a, false);
    else if (b.r == 0) cap(a, b, true);
    else band(a, b);
  }
  TriangleMesh mesh;

 private:
  int around_;

  std::uint32_t ring(double r, double z, int count) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < count; k++)
      mesh.vertices.push_back({r * std::cos(2 * pi * k / count), r * std::sin(2 * pi * k / count), z});
    return first;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
    if (turned) mesh.triangles.push_back({a, c, b});
    else mesh.triangles.push_back({a, b, c});
  }
  /// Rows about as high as a chord is long, so that they are higher where the ring is wider.
  void band(const RevolvedDistance::Point& a, const RevolvedDistance::Point& b) {
    const double slope = std::hypot(b.r - a.r, b.z - a.z), ratio = b.r / a.r;
    const double perRadius = std::abs(ratio - 1) < 1e-6 ? slope / a.r : slope / (b.r - a.r) * std::log(ratio);
    const int rows = static_cast<int>(
        std::clamp(std::round(perRadius * around_ / (2 * pi) / 1.3), 1.0, 10.0 * mostCells));
    std::uint32_t below = ring(a.r, a.z, around_);
    for (int j = 1; j <= rows; j++) {
      const double t = 1.0 * j / rows, r = j == rows ? b.r : a.r * std::pow(ratio, t),
                   share = std::abs(ratio - 1) < 1e-6 ? t : (r - a.r) / (b.r - a.r);
      const std::uint32_t above = ring(r, j == rows ? b.z : a.z + share * (b.z - a.z), around_);
      for (int k = 0; k < around_; k++) {
        const auto here = static_cast<std::uint32_t>(k), next = static_cast<std::uint32_t>((k + 1) % around_);
        triangle(below + here, below + next, above + here, false);
        triangle(below + next, above + next, above + here, false);
      }
      below = above;
    }
  }
  /// Rings of 6, 12, 18, ... vertices around a vertex on the axis.
  void cap(const RevolvedDistance::Point& rim, const RevolvedDistance::Point& tip, bool up) {
    const int rings = around_ / 6;
    std::uint32_t inner = ring(0, tip.z, 1);
    for (int j = 1; j <= rings; j++) {
      const double t = 1.0 * j / rings;
      const std::uint32_t outer = ring(t * rim.r, tip.z + t * (rim.z - tip.z), 6 * j);
      const int most = 6 * (j - 1);
      for (int side = 0; side < 6; side++)
        for (int k = 0; k < j; k++) {
          const auto out = [&](int i) {
            return outer + static_cast<std::uint32_t>((side * j + i) % (6 * j));
          };
          const auto in = [&](int i) {
            return inner + static_cast<std::uint32_t>(most == 0 ? 0 : (side * (j - 1) + i) % most);
          };
          triangle(in(k), out(k), out(k + 1), !up);
          if (k + 1 < j) triangle(in(k), out(k + 1), in(k + 1), !up);
        }
      inner = outer;
    }
  }
};

/// Returns an outline revolved about z. Chords deviate from circles by at most `sag` (m), and are short
/// enough for the shortest part of the outline. closed: joins the last point to the first.
TriangleMesh revolved(const Outline& outline, bool closed, double sag) {
  double widest = 0, steps = 24;
  const std::size_t parts = outline.size() - (closed ? 0 : 1);
  for (const auto& p : outline) widest = std::max(widest, p.r);
  for (std::size_t k = 0; k < parts; k++) {
    const auto &a = outline[k], &b = outline[(k + 1) % outline.size()];
    if (a.r > 0 && b.r > 0)
      steps = std::max(steps, 2 * pi * std::max(a.r, b.r) / (2.5 * std::hypot(b.r - a.r, b.z - a.z)));
  }
  steps = std::max(steps, pi / std::acos(std::clamp(1 - sag / widest, 0.0, 1.0)));
  Rings rings(6 * static_cast<int>(std::ceil(std::min(steps, 4.0 * mostCells) / 6)));
  for (std::size_t k = 0; k < parts; k++) rings.add(outline[k], outline[(k + 1) % outline.size()]);
  return joined(rings.mesh, widest);
}

/// Returns the outline of a torus, whose pieces are at most `sag` off.
Outline circleOf(double middle, double radius, double sag) {
  const double step = 2 * std::acos(std::clamp(1 - sag / radius, 0.0, 1.0));
  const int n = static_cast<int>(std::clamp(std::ceil(2 * pi / step), 12.0, 4.0 * mostCells));
  Outline o;
  for (int k = 0; k < n; k++)
    o.push_back({middle + radius * std::cos(2 * pi * k / n), radius * std::sin(2 * pi * k / n)});
  return o;
}

TriangleMesh unplaced(const Shape& s, double sag, const MeshLoader& load) {
  switch (s.kind) {
    case ShapeKind::Box: return boxOf(s.size);
    case ShapeKind::Sphere: return ballOf(s.radius, sag);
    case ShapeKind::Cylinder: return revolved(cylinderOutline(s.radius, s.height), false, sag);
    case ShapeKind::Glass: return revolved(glassOutline(s.radius, s.height, s.thickness), false, sag);
    case ShapeKind::Torus:
      if (s.radius2 < 0.95 * s.radius) return revolved(circleOf(s.radius, s.radius2, sag), true, sag);
      break;  // its hole is a point
    default: break;
  }
  return shapeMesh(s, sag, load);
}

/// Returns the smallest angle (rad) of a polygon as a fan around a corner.
double fanAngle(const std::vector<Vec3d>& x, std::size_t from) {
  double least = pi;
  for (std::size_t k = 1; k + 1 < x.size(); k++)
    least = std::min(least, smallestAngle(x[from], x[(from + k) % x.size()], x[(from + k + 1) % x.size()]));
  return least;
}

}  // namespace

TriangleMesh evenShapeMesh(const Shape& s, double sag, const MeshLoader& load) {
  if (s.kind == ShapeKind::Mesh) return shapeMesh(s, sag, load);
  const Shape atOrigin = withoutPlacement(s);
  const Placement p = placementOf(s, makeSignedDistance(atOrigin, load));
  TriangleMesh m;
  if (s.kind == ShapeKind::Union)
    for (const Shape& part : s.parts) appendTriangles(m, evenShapeMesh(part, sag / p.scale, load));
  else m = unplaced(atOrigin, sag / p.scale, load);
  for (Vec3d& v : m.vertices) v = p.move + p.rotation * (p.scale * v);
  return m;
}

TriangleMesh evenPolygon(const std::vector<Vec3d>& x) {
  TriangleMesh mesh;
  if (x.size() == 4) {
    const Vec3d u = x[1] - x[0], v = x[3] - x[0];
    const double wide = length(u), tall = length(v), tolerance = 1e-6 * wide * tall;
    if (std::abs(dot(u, v)) < tolerance && length(x[2] - x[1] - v) < 1e-6 * tall) {
      const double shortest = std::min(wide, tall);
      addGrid(x[0], u, v, {cellsAlong(wide, shortest), cellsAlong(tall, shortest)}, mesh);
      return mesh;
    }
  }
  std::size_t best = 0;
  for (std::size_t k = 1; k < x.size(); k++)
    if (fanAngle(x, k) > fanAngle(x, best)) best = k;
  mesh.vertices = x;
  const auto n = static_cast<std::uint32_t>(x.size()), from = static_cast<std::uint32_t>(best);
  for (std::uint32_t k = 1; k + 1 < n; k++)
    mesh.triangles.push_back({from, (from + k) % n, (from + k + 1) % n});
  return mesh;
}

}  // namespace thaw
