// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/shape_volume.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

namespace thaw {
namespace {

constexpr int points = 96;  // per edge

/// Returns the volume (m^3) if a formula exists.
std::optional<double> exactVolume(const Shape& s) {
  if (s.fitHeight) return {};
  const double scale3 = s.scale * s.scale * s.scale, pi = std::numbers::pi;
  switch (s.kind) {
    case ShapeKind::Box: return scale3 * s.size.x * s.size.y * s.size.z;
    case ShapeKind::Sphere: return scale3 * 4 / 3 * pi * s.radius * s.radius * s.radius;
    case ShapeKind::Cylinder: return scale3 * pi * s.radius * s.radius * s.height;
    case ShapeKind::Torus: return scale3 * 2 * pi * pi * s.radius * s.radius2 * s.radius2;
    default: return {};
  }
}

struct Raster {
  Bounds box;
  Vec3d cell;
  explicit Raster(const SignedDistance& shape)
      : box(shape.bounds()), cell((box.max - box.min) * (1.0 / points)) {}
  double cellVolume() const { return cell.x * cell.y * cell.z; }
};

/// Returns the number of inside points in this rank's rows.
std::int64_t countInside(const SignedDistance& shape, const Raster& r, const Reducer& all) {
  std::int64_t inside = 0;
  const bool gaps = shape.hasGaps();
  for (int row = all.rank(); row < points * points; row += all.size()) {
    const double y = r.box.min.y + (row % points + 0.5) * r.cell.y;
    const double z = r.box.min.z + (row / points + 0.5) * r.cell.z;
    for (int i = 0; i < points;) {  // all points closer than the surface are on the same side
      const Vec3d x{r.box.min.x + (i + 0.5) * r.cell.x, y, z};
      const double d = gaps ? 0 : shape.distanceWithin(x, 8 * r.cell.x);
      const double far = std::min(std::abs(d) / r.cell.x * (1 - 1e-9), 1e6);
      const int same = std::min(points - i, 1 + static_cast<int>(far));
      if (gaps ? shape.inside(x) : d < 0) inside += same;
      i += same;
    }
  }
  return inside;
}

}  // namespace

std::vector<double> shapeVolumes(std::span<const Shape* const> shapes, const MeshLoader& load, Reducer& all) {
  std::vector<double> volume(shapes.size(), 0), each(shapes.size(), 0);
  std::vector<std::int64_t> inside(shapes.size(), 0);
  for (std::size_t k = 0; k < shapes.size(); k++) {
    if (const std::optional<double> exact = exactVolume(*shapes[k])) {
      volume[k] = *exact;
      continue;
    }
    const std::shared_ptr<const SignedDistance> shape = makeSignedDistance(*shapes[k], load);
    const Raster raster(*shape);
    if (!std::isfinite(raster.cellVolume())) continue;
    each[k] = raster.cellVolume();
    inside[k] = countInside(*shape, raster, all);
  }
  all.sum(inside);
  for (std::size_t k = 0; k < shapes.size(); k++) volume[k] += static_cast<double>(inside[k]) * each[k];
  return volume;
}

}  // namespace thaw
