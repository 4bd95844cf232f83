// SPDX-License-Identifier: Apache-2.0
// Distinguishes neighbours on the same sheet from those on other sheets of a component
// (docs/validation/stability.md, rows 20 and 22).
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

/// Relation of another surfel to a surfel.
enum class Facing : unsigned char {
  Same,        ///< on the same sheet, or around an edge or bend of it
  AcrossGap,   ///< on another sheet that faces the surfel across empty space
  AcrossSheet  ///< on the back of a thin sheet
};

/// Cosine of the angle between normals beyond which two surfels belong to two sheets: 120 degrees.
inline constexpr double twoSheets = -0.5;

/// Returns the relation of two surfels by their normals, without particles. Normals more than 120 degrees
/// apart (n.n' < -1/2) belong to two sheets. They enclose a gap if each surfel lies in front of the other.
/// They enclose a sheet if each lies behind the other. Otherwise, as at folds and rims, they count as the
/// same sheet. d: m, from this surfel to the other.
inline Facing facing(const Vec3d& d, const Vec3d& normal, const Vec3d& otherNormal) {
  if (dot(normal, otherNormal) >= twoSheets) return Facing::Same;
  // heights of each surfel above the other's plane
  const double ahead = dot(d, normal), back = -dot(d, otherNormal);
  if (ahead > 0 && back > 0) return Facing::AcrossGap;
  if (ahead < 0 && back < 0) return Facing::AcrossSheet;
  return Facing::Same;
}

/// Height above a surfel's plane, in spacings of surfels, below which particles always belong to its own
/// sheet.
inline constexpr double leastGapCutoff = 0.2;

}  // namespace thaw
