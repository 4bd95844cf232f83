// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/surface_element.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/mat3.hpp"
#include "core/math/sym_eigen.hpp"

namespace thaw {
namespace {

constexpr double difference = 0.7;   // spacings, half width of finite differences
constexpr double sharpRadius = 1.6;  // spacings; surfaces of a smaller radius are edges
constexpr double planeFrom = 60;     // spacings; surfaces of a larger radius are planes
constexpr double thinnest = 0.05;    // spacings, least offset

SurfaceElement sphereOf(double offset) {
  return {{}, static_cast<float>(offset), static_cast<float>(offset)};
}

/// Largest principal curvature (1/m) of the level set of the distance through x.
double largestCurvature(const SignedDistance& shape, const Vec3d& x, double width) {
  Mat3d hessian;
  for (int k = 0; k < 3; k++) {
    Vec3d step, ahead, behind;
    step[k] = width;
    shape.distance(x + step, &ahead);
    shape.distance(x - step, &behind);
    hessian.row[k] = (ahead - behind) / (2 * width);
  }
  const SymEigen e = eigenOf(symmetric(hessian));
  return std::max({e.value[0], e.value[1], e.value[2]});
}

}  // namespace

SurfaceElement elementOfShape(const SignedDistance& shape, const Vec3d& x, double spacing) {
  Vec3d normal;
  const double depth = -shape.distance(x, &normal);
  if (depth > spacing) return {};
  const double offset = std::max(depth, thinnest * spacing);
  const double width = difference * spacing, curvature = largestCurvature(shape, x, width);
  if (!(curvature * planeFrom * spacing > 1))
    return {single(normal), static_cast<float>(offset), planeRadius};
  // the central difference over the width on a sphere of radius r is 1 / sqrt(r^2 + width^2)
  const double square = 1 / (curvature * curvature) - width * width;
  const double radius = (square > 0 ? std::sqrt(square) : 0) + depth;
  if (radius < sharpRadius * spacing) return sphereOf(offset);
  return {single(normal), static_cast<float>(offset), static_cast<float>(radius)};
}

SurfaceElement elementOfNeighbours(std::span<const Vec3d> neighbours, double spacing) {
  int nearest = 0;  // of the six next ones of a cubic lattice
  Vec3d missing;    // away from the neighbours
  for (const Vec3d& e : neighbours) {
    const double r = length(e);
    if (!(r > 0) || r > 1.8 * spacing) continue;
    if (r < 1.2 * spacing) nearest++;
    missing += e * (-1 / (r * r));
  }
  if (nearest >= 6) return {};
  const Vec3d normal = normalized(missing);
  int level = 0;
  for (const Vec3d& e : neighbours) {
    if (length(e) > 1.8 * spacing) continue;
    const double height = dot(e, normal);
    if (height > 0.1 * spacing) return sphereOf(0.5 * spacing);
    if (height > -0.1 * spacing && length(e) < 1.5 * spacing) level++;
  }
  if (level < 7) return sphereOf(0.5 * spacing);
  return {single(normal), static_cast<float>(0.5 * spacing), planeRadius};
}

}  // namespace thaw
