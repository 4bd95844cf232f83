// Sheets that come close without being one (docs/validation/stability.md B20, B22): what a surfel must not
// take for its own surroundings.
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

/// How another surfel lies to this one.
enum class Facing : unsigned char {
  Same,        ///< on the same sheet, or round an edge or a bend of it
  AcrossGap,   ///< it looks back at this one through empty space: another sheet
  AcrossSheet  ///< it looks away behind this one: the other side of a thin sheet
};

/// Cosine of the angle of normals from which on two surfels are of two sheets: 120 degrees.
inline constexpr double twoSheets = -0.5;

/// By normals alone, without particles: normals more than 120 degrees apart (n.n' < -1/2) are of two sheets;
/// what lies in front of both is a gap, what lies behind both a sheet; else (a fold, a rim) they are taken
/// for the same. d: from this surfel to the other, m.
inline Facing facing(const Vec3d& d, const Vec3d& normal, const Vec3d& otherNormal) {
  if (dot(normal, otherNormal) >= twoSheets) return Facing::Same;
  // heights of the other one over this one's plane and the reverse
  const double ahead = dot(d, normal), back = -dot(d, otherNormal);
  if (ahead > 0 && back > 0) return Facing::AcrossGap;
  if (ahead < 0 && back < 0) return Facing::AcrossSheet;
  return Facing::Same;
}

/// Particles less than this over a surfel's plane, in spacings of surfels, are its own sheet's in any case.
inline constexpr double leastCeiling = 0.2;

}  // namespace thaw
