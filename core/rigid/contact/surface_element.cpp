// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/surface_element.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quat.hpp"
#include "core/rigid/contact/edge_code.hpp"

namespace thaw {
namespace {

constexpr double halfWidth = 0.7;    // spacings, step of finite differences
constexpr double sharpRadius = 1.3;  // spacings, radius of the level set through the particle; smaller ones
                                     // are edges
constexpr double planeFrom = 60;     // spacings; surfaces of larger radius are planes
constexpr double thinnest = 1e-6;    // spacings, smallest offset
constexpr double deepest = 1.2;      // spacings, largest offset
constexpr double alongAxis = 0.999;  // smallest component along an axis, for normals along the lattice

/// Returns the largest principal curvature (1/m) of the distance's level set through x (m), by finite
/// differences along two tangents.
double largestCurvature(const SignedDistance& shape, const Vec3d& x, const Vec3d& normal, double width) {
  const Quat frame = towards(normal);
  const Vec3d tangent[2] = {rotated(frame, {1, 0, 0}), rotated(frame, {0, 1, 0})};
  double shapeOperator[2][2];
  for (int k = 0; k < 2; k++) {
    Vec3d ahead, behind;
    shape.distance(x + width * tangent[k], &ahead);
    shape.distance(x - width * tangent[k], &behind);
    for (int m = 0; m < 2; m++) shapeOperator[k][m] = dot(ahead - behind, tangent[m]) / (2 * width);
  }
  const double mean = 0.5 * (shapeOperator[0][0] + shapeOperator[1][1]),
               difference = 0.5 * (shapeOperator[0][0] - shapeOperator[1][1]),
               mixed = 0.5 * (shapeOperator[0][1] + shapeOperator[1][0]);
  return mean + std::sqrt(difference * difference + mixed * mixed);
}

}  // namespace

SurfaceElement elementOfShape(const SignedDistance& shape, const Vec3d& x, double spacing) {
  Vec3d normal;
  const double depth = -shape.distance(x, &normal);
  const double straight = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  if (depth > (straight > alongAxis ? 1 : deepest) * spacing) return {};
  const double offset = std::max(depth, thinnest * spacing);
  const double width = halfWidth * spacing, curvature = largestCurvature(shape, x, normal, width);
  if (!(curvature * planeFrom * spacing > 1))
    return {single(normal), static_cast<float>(offset), planeRadius};
  // On a sphere of radius r, the central difference over this width is 1 / sqrt(r^2 + width^2).
  const double square = 1 / (curvature * curvature) - width * width;
  const double inner = square > 0 ? std::sqrt(square) : 0, radius = inner + depth;
  if (inner < sharpRadius * spacing) return elementOfEdge(offset, sharpEdge(shape, x, spacing), spacing);
  return {single(normal), static_cast<float>(offset), static_cast<float>(radius)};
}

SurfaceElement elementOfNeighbours(std::span<const Vec3d> neighbours, double spacing) {
  int nearest = 0;  // number of present neighbours, of six in a cubic lattice
  Vec3d missing;    // vector away from the neighbours
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
    if (height > 0.1 * spacing) return elementOfEdge(0.5 * spacing, {}, spacing);
    if (height > -0.1 * spacing && length(e) < 1.5 * spacing) level++;
  }
  if (level < 7) return elementOfEdge(0.5 * spacing, {}, spacing);
  return {single(normal), static_cast<float>(0.5 * spacing), planeRadius};
}

}  // namespace thaw
