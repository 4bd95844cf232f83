// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/builtin/sheet_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/builtin/blended_shapes.hpp"

namespace thaw {
namespace {

using std::numbers::pi;

std::uint32_t parts(double length, double spacing) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(length / spacing)));
}

TriangleMesh squares(std::uint32_t nx, std::uint32_t ny) {
  TriangleMesh m;
  for (std::uint32_t j = 0; j <= ny; j++)
    for (std::uint32_t i = 0; i <= nx; i++)
      m.vertices.push_back({static_cast<double>(i) / nx - 0.5, static_cast<double>(j) / ny - 0.5, 0});
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * (nx + 1) + i; };
  for (std::uint32_t j = 0; j < ny; j++)
    for (std::uint32_t i = 0; i < nx; i++) {
      m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return m;
}

/// Corners and faces of an icosahedron, outward.
struct Icosahedron {
  Vec3d corner[12];
  std::uint32_t face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                               {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                               {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                               {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  Icosahedron() {
    const double g = 0.5 * (1 + std::sqrt(5.0));
    const Vec3d c[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                         {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (int i = 0; i < 12; i++) corner[i] = normalized(c[i]);
  }
};

/// Returns a unit sphere with n parts per edge: 10 n^2 + 2 vertices. Corners are first, then edges, then
/// faces.
TriangleMesh unitSphere(std::uint32_t n) {
  const Icosahedron ico;
  TriangleMesh m;
  for (const Vec3d& c : ico.corner) m.vertices.push_back(c);
  std::uint32_t edgeFirst[12][12] = {};
  // equal angles along an edge give more uniform triangles than equal lengths
  const double angle = std::acos(dot(ico.corner[0], ico.corner[11]));
  const auto along = [&](const Vec3d& a, const Vec3d& b, double t) {
    return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
  };
  for (const auto& f : ico.face)
    for (int k = 0; k < 3; k++) {
      const std::uint32_t a = f[k], b = f[(k + 1) % 3];
      if (a > b) continue;
      edgeFirst[a][b] = static_cast<std::uint32_t>(m.vertices.size());
      for (std::uint32_t i = 1; i < n; i++)
        m.vertices.push_back(along(ico.corner[a], ico.corner[b], static_cast<double>(i) / n));
    }
  const auto onEdge = [&](std::uint32_t a, std::uint32_t b, std::uint32_t i) {  // i of n parts from a to b
    if (i == 0) return a;
    if (i == n) return b;
    return a < b ? edgeFirst[a][b] + i - 1 : edgeFirst[b][a] + n - i - 1;
  };
  for (const auto& f : ico.face) {
    const auto inside = static_cast<std::uint32_t>(m.vertices.size());
    // row j runs parallel to edge 0-1 from edge 0-2 to edge 1-2, with n - j parts
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      if (j == 0) return onEdge(f[0], f[1], i);
      if (i == 0) return onEdge(f[0], f[2], j);
      if (i + j == n) return onEdge(f[1], f[2], j);
      return inside + (j - 1) * (n - 1) - (j - 1) * j / 2 + i - 1;
    };
    for (std::uint32_t j = 1; j + 1 < n; j++)
      for (std::uint32_t i = 1; i + j < n; i++) {
        // mean of the three angular divisions, one per side
        const std::uint32_t k = n - i - j;
        const auto between = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t step,
                                 std::uint32_t of) {
          const Vec3d p = along(ico.corner[a], ico.corner[c], static_cast<double>(of) / n),
                      q = along(ico.corner[b], ico.corner[c], static_cast<double>(of) / n);
          const double apart = std::acos(std::min(1.0, dot(p, q))), t = static_cast<double>(step) / (n - of);
          return (std::sin((1 - t) * apart) * p + std::sin(t * apart) * q) / std::sin(apart);
        };
        m.vertices.push_back(normalized(between(f[0], f[1], f[2], i, j) + between(f[1], f[2], f[0], j, k) +
                                        between(f[2], f[0], f[1], k, i)));
      }
    for (std::uint32_t j = 0; j < n; j++)
      for (std::uint32_t i = 0; i + j < n; i++) {
        m.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < n) m.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return m;
}

// ---- the head ----
// Signed distances of a sculpture's parts, blended; lengths in heights of the head, centre at the origin.
double headValue(const Vec3d& y) {
  const Vec3d x{std::abs(y.x), y.y, y.z};
  double d = ellipsoid(x, {0, 0.05, 0.13}, {0.33, 0.42, 0.37});                             // skull
  d = blend(d, ellipsoid(x, {0, -0.10, -0.10}, {0.275, 0.30, 0.36}), 0.10);                 // face
  d = blend(d, limb(x, {0.21, -0.03, -0.22}, {0, -0.29, -0.40}, 0.08, 0.09), 0.12);         // jaw
  d = blend(d, ellipsoid(x, {0, -0.345, -0.415}, {0.075, 0.065, 0.065}), 0.07);             // chin
  d = blend(d, ellipsoid(x, {0.165, -0.27, -0.09}, {0.085, 0.075, 0.075}), 0.07);           // cheekbones
  d = carve(d, ellipsoid(x, {0.128, -0.43, 0.035}, {0.095, 0.10, 0.065}), 0.06);            // eye sockets
  d = blend(d, ellipsoid(x, {0.125, -0.315, 0.03}, {0.062, 0.05, 0.036}), 0.015);           // eyes
  d = blend(d, limb(x, {0.045, -0.385, 0.105}, {0.19, -0.33, 0.125}, 0.028, 0.022), 0.05);  // brows
  d = blend(d, limb(x, {0, -0.385, 0.07}, {0, -0.465, -0.135}, 0.032, 0.048), 0.055);       // nose
  d = blend(d, ellipsoid(x, {0.048, -0.425, -0.15}, {0.038, 0.045, 0.03}), 0.03);
  d = blend(d, limb(x, {0, -0.405, -0.245}, {0.085, -0.365, -0.26}, 0.026, 0.014), 0.02);  // lips
  d = blend(d, limb(x, {0, -0.40, -0.295}, {0.07, -0.365, -0.285}, 0.028, 0.016), 0.02);
  d = blend(d, ellipsoid(x, {0.335, 0.03, -0.005}, {0.035, 0.075, 0.115}), 0.03);  // ears
  d = blend(d, limb(x, {0, 0.10, -0.25}, {0, 0.13, -0.42}, 0.19, 0.185), 0.10);    // neck, closed below
  return d;
}

}  // namespace

TriangleMesh gridSheet(double width, double depth, double spacing) {
  TriangleMesh m = squares(parts(width, spacing), parts(depth, spacing));
  for (Vec3d& x : m.vertices) x = {x.x * width, x.y * depth, 0};
  return m;
}

TriangleMesh sphereSheet(double radius, double spacing) {
  TriangleMesh m = unitSphere(parts(1.107 * radius, spacing));
  for (Vec3d& x : m.vertices) x = radius * x;
  return m;
}

TriangleMesh headSheet(double height, double spacing) {
  TriangleMesh m = unitSphere(parts(0.45 * height, spacing));
  for (Vec3d& x : m.vertices) {
    double in = 0, out = 1;  // outermost crossing along the ray
    while (out > 0.1 && headValue(out * x) > 0) out -= 1.0 / 256;
    in = out;
    out += 1.0 / 256;
    for (int k = 0; k < 48; k++) {
      const double middle = 0.5 * (in + out);
      (headValue(middle * x) > 0 ? out : in) = middle;
    }
    x = height * in * x;
  }
  return m;
}

TriangleMesh domeSheet(double radius, double height, double spacing, int ribs, double ribHeight) {
  const std::uint32_t rings = parts(radius, spacing);
  TriangleMesh m;
  m.vertices.push_back({});
  const auto first = [](std::uint32_t k) { return k == 0 ? 0u : 1 + 3 * k * (k - 1); };
  for (std::uint32_t k = 1; k <= rings; k++)
    for (std::uint32_t j = 0; j < 6 * k; j++) {
      const double a = 2 * pi * j / (6.0 * k), r = radius * k / rings;
      m.vertices.push_back({r * std::cos(a), r * std::sin(a), 0});
    }
  for (std::uint32_t k = 1; k <= rings; k++)
    for (std::uint32_t side = 0; side < 6; side++)
      for (std::uint32_t i = 0; i < k; i++) {
        const auto outer = [&](std::uint32_t j) { return first(k) + (side * k + j) % (6 * k); };
        const auto inner = [&](std::uint32_t j) {
          return k == 1 ? 0u : first(k - 1) + (side * (k - 1) + j) % (6 * (k - 1));
        };
        m.triangles.push_back({outer(i), outer(i + 1), inner(i)});
        if (i + 1 < k) m.triangles.push_back({inner(i), outer(i + 1), inner(i + 1)});
      }
  for (Vec3d& x : m.vertices) {
    const double r = std::sqrt(x.x * x.x + x.y * x.y) / radius,
                 fade = std::min(1.0, std::max(0.0, (r - 0.1) / 0.4));
    x.z = height * (1 - r * r) +
          (ribs > 0 ? 0.5 * ribHeight * fade * std::cos(ribs * std::atan2(x.y, x.x)) : 0);
  }
  return m;
}

TriangleMesh foreheadSheet(double radius, double width, double height, double spacing, double depth,
                           int wrinkles) {
  TriangleMesh m = squares(parts(width, spacing), parts(height, spacing));
  for (Vec3d& x : m.vertices) {
    const double u = x.x, v = x.y;  // -1/2 to 1/2
    const auto fade = [](double s, double over) {
      const double t = std::clamp((0.5 - std::abs(s)) / over, 0.0, 1.0);
      return t * t * (3 - 2 * t);
    };
    // furrows bend up above the brows and down between them, with irregular phase
    const double bent = v + 0.05 * std::cos(2 * pi * 2 * u) + 0.012 * std::sin(2 * pi * (3.3 * u + 1.7 * v));
    const double wave = 0.5 + 0.5 * std::cos(2 * pi * wrinkles * bent + 0.6 * std::sin(2 * pi * u));
    const double rise = wrinkles > 0 ? depth * fade(u, 0.22) * fade(v, 0.15) * wave * wave *
                                           (0.8 + 0.2 * std::cos(2 * pi * (1.3 * u + 2.1 * v)))
                                     : 0;
    const double a = u * width / radius, b = v * height / radius;
    x = (radius + rise) * Vec3d{std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
  }
  return m;
}

}  // namespace thaw
