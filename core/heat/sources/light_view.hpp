// SPDX-License-Identifier: Apache-2.0
// Grids of rays of lamps and lasers, and the power of each ray. Rays are parallel, or start at a point and
// pass through a face of a cube. They depend only on the scene, the time and the bounds of the bodies.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

enum class LightProfile {
  Uniform,   ///< irradiance across the direction
  Gaussian,  ///< beam
  Isotropic,
  Cosine  ///< Lambert's law about the direction
};

/// Light of one step: a lamp, a point of an area lamp, or a laser.
struct LightSource {
  LightProfile profile = LightProfile::Isotropic;
  double power = 0;   ///< W, mean over the step; Uniform: W/m^2
  double radius = 0;  ///< m, Gaussian: at 1/e^2 of the largest intensity
  double depth = 0;   ///< m, absorption depth; 0: at the surface
  Vec3d position{};   ///< m
  Vec3d direction{};  ///< 1, unit
  bool laser = false;
  std::size_t source = 0;  ///< number over the lamps of the scene, then its lasers
  std::size_t number = 0;  ///< number over all sources of the scene and all points of area lamps
};

/// Rays of a source. Cell (i, j) has the ray through its centre, ((i + 1/2) cell, (j + 1/2) cell).
struct LightView {
  std::size_t source = 0;      ///< index into the sources of the step
  std::size_t cacheIndex = 0;  ///< unique among the views of all steps
  bool parallel = true;
  Vec3d origin{};                       ///< m, origin of the coordinates; rays that are not parallel start
                                        ///< here
  Vec3d side{}, up{}, ahead{};          ///< unit vectors: coordinates are along side and up, light is along
                                        ///< ahead
  double cell = 0;                      ///< m, width; a tangent if rays are not parallel
  std::array<std::int64_t, 2> low{};    ///< first cell, of both axes
  std::array<std::int64_t, 2> count{};  ///< cells
  std::size_t first = 0;                ///< its first cell in the map of all views
  std::size_t cells() const { return static_cast<std::size_t>(count[0] * count[1]); }
};

/// Ray from a point (m) along a unit vector.
struct LightRay {
  Vec3d start{}, direction{};
};

/// Coordinates (m) of a point in a view, and its distance along the light (m).
struct Sight {
  Vec3d seen{};
  double depth = 0;
};

inline Sight sightOf(const LightView& v, const Vec3d& x) {
  const Vec3d d = x - v.origin;
  const Vec3d seen{dot(d, v.side), dot(d, v.up), dot(d, v.ahead)};
  return {seen, v.parallel ? seen.z : length(d)};
}

/// Appends the views of source `index` that can hit bodies within these bounds. Cells are half a spacing wide
/// at the bodies, or wider in views that would have more than two million cells. spacing: m.
void addViews(const LightSource& source, std::size_t index, const Bounds& bodies, double spacing,
              std::vector<LightView>& views);

LightRay rayOf(const LightView& view, std::int64_t i, std::int64_t j);

/// Returns the power (W) of a cell for a source with a power of 1, by the exact integral over the cell.
double powerOfCell(const LightSource& source, const LightView& view, std::int64_t i, std::int64_t j);

/// Width (m) of a cell at this distance along the light.
inline double cellWidth(const LightView& v, double depth) { return v.parallel ? v.cell : v.cell * depth; }

/// Cells [low, high) along both axes.
struct CellRange {
  std::array<std::int64_t, 2> low{}, high{};
  bool empty() const { return low[0] >= high[0] || low[1] >= high[1]; }
};

/// Returns the cells whose rays may pass a point within `reach` (m).
inline CellRange cellsNear(const LightView& v, const Sight& s, double reach) {
  std::array<double, 2> low, high;
  for (std::size_t a = 0; a < 2; a++) {
    const double at = s.seen[static_cast<int>(a)];
    if (v.parallel) {
      low[a] = at - reach;
      high[a] = at + reach;
    } else if (s.seen.z > 1.01 * reach) {  // tangents of the sphere around the point
      const double z = s.seen.z, below = z * z - reach * reach, half = reach * std::sqrt(at * at + below);
      low[a] = (at * z - half) / below;
      high[a] = (at * z + half) / below;
    } else if (s.depth < 4 * reach && s.seen.z > -reach) {
      low[a] = -1;
      high[a] = 1;
    } else {
      return {};
    }
  }
  CellRange range;
  for (std::size_t a = 0; a < 2; a++) {
    const double first = static_cast<double>(v.low[a]), end = static_cast<double>(v.low[a] + v.count[a]);
    range.low[a] = static_cast<std::int64_t>(std::clamp(std::ceil(low[a] / v.cell - 0.5), first, end));
    range.high[a] = static_cast<std::int64_t>(std::clamp(std::floor(high[a] / v.cell - 0.5) + 1, first, end));
  }
  return range;
}

/// Calls use(cell, squared distance in m^2) for the rays that pass a point within `reach` (m), in the
/// order of the cells. cell: index within the view.
template<class Use> void eachRayNear(const LightView& v, const Sight& s, double reach, Use&& use) {
  const CellRange range = cellsNear(v, s, reach);
  if (range.empty()) return;
  const double reach2 = reach * reach;
  for (std::int64_t j = range.low[1]; j < range.high[1]; j++) {
    const double y = (static_cast<double>(j) + 0.5) * v.cell;
    const std::size_t row = static_cast<std::size_t>((j - v.low[1]) * v.count[0]);
    for (std::int64_t i = range.low[0]; i < range.high[0]; i++) {
      const double x = (static_cast<double>(i) + 0.5) * v.cell;
      double d2 = 0;
      if (v.parallel) {
        d2 = (s.seen.x - x) * (s.seen.x - x) + (s.seen.y - y) * (s.seen.y - y);
      } else {
        const double along = s.seen.x * x + s.seen.y * y + s.seen.z;
        if (along <= 0) continue;
        const double d = s.depth * s.depth - along * along / (1 + x * x + y * y);
        d2 = d > 0 ? d : 0;
      }
      if (d2 < reach2) use(row + static_cast<std::size_t>(i - v.low[0]), d2);
    }
  }
}

}  // namespace thaw
