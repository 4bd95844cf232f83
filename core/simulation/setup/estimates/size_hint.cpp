// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/estimates/size_hint.hpp"

#include <algorithm>
#include <cstdio>

#include "core/geometry/builtin/builtin_meshes.hpp"

namespace thaw {
namespace {

std::string written(const char* format, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// Returns true if the body, scaled by the factor, is several particles wide and fits into the domain.
bool fits(const Scene& s, const Vec3d& size, double factor) {
  for (int a = 0; a < 3; a++)
    if (factor * size[a] > s.domain.max[a] - s.domain.min[a]) return false;
  return factor * std::max({size.x, size.y, size.z}) >= 4 * s.spacing;
}

}  // namespace

std::string sizeHint(const Scene& s, const Shape& shape, const Bounds& b) {
  const Vec3d size = b.max - b.min;
  if (size.x < 0 || size.y < 0 || size.z < 0)
    return "; its shape is empty: the subtracted parts cover it, or its parts do not intersect";
  std::string hint = written("; its size is %.3g x %.3g x %.3g m", size.x, size.y, size.z);
  if (shape.kind != ShapeKind::Mesh || namesBuiltin(shape.mesh) || fits(s, size, 1)) return hint;
  const struct {
    double factor;
    const char* unit;
  } units[] = {{1e-3, "millimetres"}, {1e-2, "centimetres"}, {0.0254, "inches"}};
  if (!shape.fitHeight && shape.scale == 1)
    for (const auto& [factor, unit] : units)
      if (fits(s, size, factor))
        return hint +
               written(": if its file is in %s, set place = { scale = %g }, else place = { height = ... }",
                       unit, factor);
  if (!shape.fitHeight && shape.scale != 1 && fits(s, size, 1 / shape.scale))
    return hint + written(": without its place.scale of %g it would be %.3g m high", shape.scale,
                          size.z / shape.scale);
  return hint + ": set place.scale or place.height";
}

std::string lengthText(double metres) { return written("%g m", metres); }

std::string narrowAxes(const Bounds& b, double spacing) {
  std::string axes;
  for (int a = 0; a < 3; a++)
    if (const double size = b.max[a] - b.min[a]; size < spacing * (1 - 1e-6))
      axes += written("%s%.3g m along %c", axes.empty() ? "" : ", ", size, "xyz"[a]);
  return axes;
}

}  // namespace thaw
