// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/light_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/tangent.hpp"

namespace thaw {
namespace {

using std::numbers::pi;

constexpr double mostCells = 1 << 21;  ///< largest number of cells in a view
constexpr double beamRadii = 3;        ///< half width of a beam, in its radii: 2e-9 of the power lies farther
                                       ///< out
constexpr double widestCell = 0.5;     ///< spacings
constexpr double margin = 2;           ///< spacings around the bodies

/// Returns a unit vector normal to n.
Vec3d acrossOf(const Vec3d& n) { return normalized(cross(leastAxis(n), n)); }

std::array<Vec3d, 8> cornersOf(const Bounds& b) {
  std::array<Vec3d, 8> corners;
  for (std::size_t k = 0; k < 8; k++)
    corners[k] = {k & 1 ? b.max.x : b.min.x, k & 2 ? b.max.y : b.min.y, k & 4 ? b.max.z : b.min.z};
  return corners;
}

/// Sets the cells of [low, high]. Doubles their width while a view has too many.
bool setCells(LightView& v, const std::array<double, 2>& low, const std::array<double, 2>& high) {
  if (!(high[0] > low[0] && high[1] > low[1])) return false;
  while ((high[0] - low[0]) / v.cell * ((high[1] - low[1]) / v.cell) > mostCells) v.cell *= 2;
  for (std::size_t a = 0; a < 2; a++) {
    v.low[a] = static_cast<std::int64_t>(std::floor(low[a] / v.cell));
    v.count[a] = static_cast<std::int64_t>(std::ceil(high[a] / v.cell)) - v.low[a];
  }
  return true;
}

void append(LightView v, std::vector<LightView>& views) {
  v.first = views.empty() ? 0 : views.back().first + views.back().cells();
  views.push_back(v);
}

void addParallelView(const LightSource& s, LightView v, const Bounds& bodies, double spacing,
                     std::vector<LightView>& views) {
  v.cell = widestCell * spacing;
  std::array<double, 2> low{never, never}, high{-never, -never};
  for (const Vec3d& x : cornersOf(bodies)) {
    const Sight at = sightOf(v, x);
    for (std::size_t a = 0; a < 2; a++) {
      low[a] = std::min(low[a], at.seen[static_cast<int>(a)] - margin * spacing);
      high[a] = std::max(high[a], at.seen[static_cast<int>(a)] + margin * spacing);
    }
  }
  if (s.profile == LightProfile::Gaussian)
    for (std::size_t a = 0; a < 2; a++) {
      low[a] = std::max(low[a], -beamRadii * s.radius);
      high[a] = std::min(high[a], beamRadii * s.radius);
    }
  if (setCells(v, low, high)) append(v, views);
}

/// Returns true if all bodies lie beyond one of the planes through the point and an edge of the face.
bool missesFace(const LightView& v, const std::array<Vec3d, 8>& corners, double margins) {
  for (int a = 0; a < 2; a++)
    for (const double sign : {1.0, -1.0}) {
      const auto beyond = [&](const Vec3d& x) {
        const Vec3d seen = sightOf(v, x).seen;
        return sign * seen[a] - seen.z > 2 * margins;
      };
      if (std::ranges::all_of(corners, beyond)) return true;
    }
  return false;
}

/// Returns the cell width of a cube's faces (a tangent). It is half a spacing at a mean distance of the
/// bodies, and at most one spacing at the largest. The number of cells across half a face takes only a few
/// values, so cells seldom change as bodies move.
double faceCell(const Vec3d& origin, const Bounds& bodies, double spacing) {
  Vec3d near{}, far{};
  for (int a = 0; a < 3; a++) {
    near[a] = std::max({0.0, bodies.min[a] - origin[a], origin[a] - bodies.max[a]});
    far[a] = std::max(std::abs(bodies.min[a] - origin[a]), std::abs(bodies.max[a] - origin[a]));
  }
  const double farthest = std::max(length(far), spacing), nearest = std::max(length(near), 0.1 * farthest);
  const double cells = std::max(std::sqrt(nearest * farthest) / (widestCell * spacing), farthest / spacing);
  return 1 / std::ceil(std::exp2(std::ceil(4 * std::log2(cells)) / 4));
}

/// Adds a face of the cube around a point. If all corners of the bodies' bounds are ahead, only the part
/// towards the bodies is added.
void addFace(LightView v, const Bounds& bodies, double spacing, std::vector<LightView>& views) {
  std::array<double, 2> low{never, never}, high{-never, -never};
  const std::array<Vec3d, 8> corners = cornersOf(bodies);
  if (missesFace(v, corners, margin * spacing)) return;
  bool allAhead = true;
  for (const Vec3d& x : corners) {
    const Sight at = sightOf(v, x);
    if (!(at.seen.z > 2 * margin * spacing)) {
      allAhead = false;
      continue;
    }
    const double near = margin * spacing / at.seen.z;
    for (std::size_t a = 0; a < 2; a++) {
      const double t = at.seen[static_cast<int>(a)] / at.seen.z, wide = near * (1 + std::abs(t));
      low[a] = std::min(low[a], t - wide);
      high[a] = std::max(high[a], t + wide);
    }
  }
  v.cell = faceCell(v.origin, bodies, spacing);
  for (std::size_t a = 0; a < 2; a++) {
    low[a] = allAhead ? std::clamp(low[a], -1.0, 1.0) : -1;
    high[a] = allAhead ? std::clamp(high[a], -1.0, 1.0) : 1;
  }
  if (setCells(v, low, high)) append(v, views);
}

/// Returns the integral of the solid angle over the rectangle from the face's centre to (x, y).
double solidAngle(double x, double y) { return std::atan2(x * y, std::sqrt(1 + x * x + y * y)); }

/// Returns the integral of (cosine to `ahead`) / pi over the solid angle, from the face's centre to (x, y).
double cosineAhead(double x, double y) {
  const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
  return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * pi);
}

/// Returns the integral of (cosine to `up`) / pi over the solid angle, up to (x, y). Its lower limit in y is
/// arbitrary.
double cosineUp(double x, double y) {
  const double b = std::sqrt(1 + y * y);
  return -std::atan(x / b) / b / (2 * pi);
}

/// Returns the integral over the part of a cell on the face. corner(x, y): the antiderivative.
template<class Corner> double overCell(double x, double y, double cell, Corner&& corner) {
  const double right = std::min(x + cell, 1.0), top = std::min(y + cell, 1.0);
  x = std::max(x, -1.0), y = std::max(y, -1.0);
  if (!(right > x && top > y)) return 0;
  return corner(right, top) - corner(x, top) - corner(right, y) + corner(x, y);
}

/// Returns the fraction of a Gaussian beam's power between two coordinates (m) along one axis normal to the
/// beam.
double gaussianBetween(double from, double to, double radius) {
  const double scale = std::numbers::sqrt2 / radius;
  return 0.5 * (std::erf(scale * to) - std::erf(scale * from));
}

}  // namespace

void addViews(const LightSource& s, std::size_t index, const Bounds& bodies, double spacing,
              std::vector<LightView>& views) {
  LightView v;
  v.source = index;
  v.cacheIndex = 6 * s.number;
  v.parallel = s.profile == LightProfile::Uniform || s.profile == LightProfile::Gaussian;
  v.origin = s.position;
  const Vec3d ahead = s.direction, side = acrossOf(ahead), up = cross(ahead, side);
  v.side = side, v.up = up, v.ahead = ahead;
  if (v.parallel) return addParallelView(s, v, bodies, spacing, views);
  const bool back = s.profile == LightProfile::Isotropic;
  const auto face = [&](const Vec3d& to, const Vec3d& across, const Vec3d& upward) {
    v.ahead = to, v.side = across, v.up = upward;
    addFace(v, bodies, spacing, views);
    v.cacheIndex++;
  };
  face(ahead, side, up);
  if (back) face(-ahead, side, up);
  for (const double sign : {1.0, -1.0}) {
    face(sign * side, up, ahead);
    face(sign * up, side, ahead);
  }
}

LightRay rayOf(const LightView& v, std::int64_t i, std::int64_t j) {
  const double x = (static_cast<double>(i) + 0.5) * v.cell, y = (static_cast<double>(j) + 0.5) * v.cell;
  const Vec3d across = v.side * x + v.up * y;
  if (v.parallel) return {v.origin + across, v.ahead};
  return {v.origin, (v.ahead + across) / std::sqrt(1 + x * x + y * y)};
}

double powerOfCell(const LightSource& s, const LightView& v, std::int64_t i, std::int64_t j) {
  const double x = static_cast<double>(i) * v.cell, y = static_cast<double>(j) * v.cell;
  switch (s.profile) {
    case LightProfile::Uniform: return v.cell * v.cell;
    case LightProfile::Gaussian:
      return gaussianBetween(x, x + v.cell, s.radius) * gaussianBetween(y, y + v.cell, s.radius);
    case LightProfile::Isotropic: return overCell(x, y, v.cell, solidAngle) / (4 * pi);
    case LightProfile::Cosine:
      if (dot(v.ahead, s.direction) > 0.5) return overCell(x, y, v.cell, cosineAhead);
      return y < 0 ? 0 : overCell(x, y, v.cell, cosineUp);  // no light behind the lamp
  }
  return 0;
}

}  // namespace thaw
