// SPDX-License-Identifier: Apache-2.0
#include "io/render/light/depth_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/render/light/triangle_rows.hpp"

namespace thaw {

namespace {

constexpr float nothing = std::numeric_limits<float>::lowest();

float lengthOf(const Vec3f& a) { return std::sqrt(dot(a, a)); }

void drawSphere(DepthMap& map, const Discs& discs, std::size_t i) {
  const float scale = 1 / map.cell;
  const Vec3f& p = discs.positions[i];
  const float u = (dot(p, map.across) - map.left) * scale, v = (dot(p, map.along) - map.low) * scale,
              depth = dot(p, map.toLight);
  const float r = std::max(discs.radius(i) * scale, 0.5f);
  const int y0 = std::max(0, static_cast<int>(std::ceil(v - r - 0.5f))),
            y1 = std::min(map.rows - 1, static_cast<int>(std::floor(v + r - 0.5f)));
  for (int y = y0; y <= y1; y++) {
    const float dy = static_cast<float>(y) + 0.5f - v, half = std::sqrt(std::max(0.0f, r * r - dy * dy));
    const int x0 = std::max(0, static_cast<int>(std::ceil(u - half - 0.5f)));
    const int x1 = std::min(map.columns - 1, static_cast<int>(std::floor(u + half - 0.5f)));
    float* row = map.nearest.data() + static_cast<std::size_t>(y) * map.columns;
    for (int x = x0; x <= x1; x++) row[x] = std::max(row[x], depth);
  }
}

/// Draws a tilted disc; the depth of each cell is that of its plane.
void drawDisc(DepthMap& map, const Discs& discs, std::size_t i) {
  const float scale = 1 / map.cell;
  const Vec3f &p = discs.positions[i], &n = discs.normals[i];
  const float nu = dot(n, map.across), nv = dot(n, map.along), nw = dot(n, map.toLight);
  if (nw <= 0.02f) return;
  const float u = (dot(p, map.across) - map.left) * scale, v = (dot(p, map.along) - map.low) * scale,
              depth = dot(p, map.toLight);
  const float r = std::max(discs.radius(i) * scale, 0.5f), su = -nu / nw, sv = -nv / nw;
  const float hu = std::max(0.5f, r * std::sqrt(std::max(0.0f, 1 - nu * nu))),
              hv = std::max(0.5f, r * std::sqrt(std::max(0.0f, 1 - nv * nv)));
  const int y0 = std::max(0, static_cast<int>(std::ceil(v - hv - 0.5f))),
            y1 = std::min(map.rows - 1, static_cast<int>(std::floor(v + hv - 0.5f)));
  const int x0 = std::max(0, static_cast<int>(std::ceil(u - hu - 0.5f))),
            x1 = std::min(map.columns - 1, static_cast<int>(std::floor(u + hu - 0.5f)));
  for (int y = y0; y <= y1; y++) {
    const float dy = static_cast<float>(y) + 0.5f - v;
    float* row = map.nearest.data() + static_cast<std::size_t>(y) * map.columns;
    for (int x = x0; x <= x1; x++) {
      const float dx = static_cast<float>(x) + 0.5f - u, dz = su * dx + sv * dy, away = dx * dx + dy * dy;
      if (away + dz * dz <= r * r) row[x] = std::max(row[x], depth + dz * map.cell);
      else if (away <= 0.25f) row[x] = std::max(row[x], depth);  // edge on: thinner than a cell
    }
  }
}

/// Draws a triangle; the depth of each cell is that of its plane.
void drawTriangle(DepthMap& map, const std::array<Vec3f, 3>& corners) {
  GridTriangle t;
  float depth[3];
  for (std::size_t k = 0; k < 3; k++) {
    t.x[k] = (dot(corners[k], map.across) - map.left) / map.cell;
    t.y[k] = (dot(corners[k], map.along) - map.low) / map.cell;
    depth[k] = dot(corners[k], map.toLight);
  }
  const float area2 = t.area2();
  if (!(area2 > 1e-6f)) return;
  const float b = depth[1] - depth[0], c = depth[2] - depth[0],
              alongX = (b * (t.y[2] - t.y[0]) - c * (t.y[1] - t.y[0])) / area2,
              alongY = (c * (t.x[1] - t.x[0]) - b * (t.x[2] - t.x[0])) / area2;
  forRowsInside(t, map.columns, map.rows, [&](int y, int x0, int x1) {
    float* row = map.nearest.data() + static_cast<std::size_t>(y) * map.columns;
    const float start = depth[0] + alongY * (static_cast<float>(y) + 0.5f - t.y[0]);
    for (int x = x0; x <= x1; x++)
      row[x] = std::max(row[x], start + alongX * (static_cast<float>(x) + 0.5f - t.x[0]));
  });
}

}  // namespace

float DepthMap::visible(const Vec3f& point, float bias, int taps) const {
  if (columns == 0) return 1;
  const float x = (dot(point, across) - left) / cell - 0.5f, y = (dot(point, along) - low) / cell - 0.5f,
              depth = dot(point, toLight) + bias;
  const float reach = static_cast<float>(taps) + 1;
  if (x < -reach || y < -reach || x > static_cast<float>(columns) + reach ||
      y > static_cast<float>(rows) + reach)
    return 1;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  // A box of bilinear samples: inner cells count fully, both ends of each row and column by their fraction.
  float lit = 0;
  for (int j = -taps; j <= taps + 1; j++) {
    const float wy = j == -taps ? 1 - fy : j == taps + 1 ? fy : 1;
    const int cy = y0 + j;
    for (int i = -taps; i <= taps + 1; i++) {
      const float w = wy * (i == -taps ? 1 - fx : i == taps + 1 ? fx : 1);
      const int cx = x0 + i;
      const bool inside = cx >= 0 && cy >= 0 && cx < columns && cy < rows;
      if (!inside || nearest[static_cast<std::size_t>(cy) * columns + cx] <= depth) lit += w;
    }
  }
  const float side = static_cast<float>(2 * taps + 1);
  return lit / (side * side);
}

DepthMap makeDepthMap(const Discs& discs, const Vec3f& toLight, float cellsPerRadius, int limit) {
  DepthMap map;
  map.toLight = toLight;
  const Vec3f pole = std::abs(toLight.z) < 0.9f ? Vec3f{0, 0, 1} : Vec3f{1, 0, 0};
  map.across = cross(pole, toLight);
  map.across = map.across / lengthOf(map.across);
  map.along = cross(toLight, map.across);
  if (discs.positions.empty() && discs.triangles.empty()) return map;
  float right = nothing, high = nothing, largest = 0;
  map.left = map.low = -nothing;
  double radii = 0;
  for (std::size_t i = 0; i < discs.positions.size(); i++) {
    const float u = dot(discs.positions[i], map.across), v = dot(discs.positions[i], map.along),
                r = discs.radius(i);
    map.left = std::min(map.left, u), right = std::max(right, u);
    map.low = std::min(map.low, v), high = std::max(high, v);
    largest = std::max(largest, r);
    radii += r;
  }
  map.left -= largest, map.low -= largest, right += largest, high += largest;
  for (const auto& t : discs.triangles)
    for (const Vec3f& x : t) {
      const float u = dot(x, map.across), v = dot(x, map.along);
      map.left = std::min(map.left, u), right = std::max(right, u);
      map.low = std::min(map.low, v), high = std::max(high, v);
    }
  const float typical = discs.positions.empty()
                            ? 0
                            : static_cast<float>(radii / static_cast<double>(discs.positions.size()));
  map.cell = std::max(typical / cellsPerRadius,
                      std::max(right - map.left, high - map.low) / static_cast<float>(limit));
  map.columns = std::clamp(static_cast<int>(std::ceil((right - map.left) / map.cell)), 1, limit);
  map.rows = std::clamp(static_cast<int>(std::ceil((high - map.low) / map.cell)), 1, limit);
  map.nearest.assign(static_cast<std::size_t>(map.columns) * map.rows, nothing);
  for (std::size_t i = 0; i < discs.positions.size(); i++)
    if (discs.normals.empty()) drawSphere(map, discs, i);
    else drawDisc(map, discs, i);
  for (const auto& t : discs.triangles) drawTriangle(map, t);
  return map;
}

}  // namespace thaw
