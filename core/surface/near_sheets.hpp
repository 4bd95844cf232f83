// Sheets that come close without being one (accuracy.md B20, B22): what a surfel must not take for its own surroundings.
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

/// How another surfel lies to this one.
enum class Facing : unsigned char {
  Same,        ///< on the same sheet, or round an edge or a bend of it
  AcrossGap,   ///< it looks back at this one through empty space: another sheet
  AcrossSheet  ///< it looks away behind this one: the other side of a thin sheet
};

/// By normals alone, without particles: normals more than 120 degrees apart (n.n' < -1/2) are of two sheets; what lies in front of both is a
/// gap, what lies behind both a sheet; else (a fold, a rim) they are taken for the same. d: from this surfel to the other, m.
inline Facing facing(const Vec3d& d, const Vec3d& normal, const Vec3d& otherNormal) {
  if (dot(normal, otherNormal) >= -0.5) return Facing::Same;
  const double ahead = dot(d, normal), back = -dot(d, otherNormal);  // heights of the other one over this one's plane and the reverse
  if (ahead > 0 && back > 0) return Facing::AcrossGap;
  if (ahead < 0 && back < 0) return Facing::AcrossSheet;
  return Facing::Same;
}

/// Thickness of the sheet between two surfels, m: along the mean of the normals; 0 unless AcrossSheet.
inline double sheetThickness(const Vec3d& d, const Vec3d& normal, const Vec3d& otherNormal) {
  if (facing(d, normal, otherNormal) != Facing::AcrossSheet) return 0;
  return -dot(d, normalized(normal - otherNormal));
}

/// A gap between two surfels that face each other is empty if no particle is near its middle: nearest2 is the square of the distance from the
/// midpoint to the nearest particle (m^2), spacing that of the particles (m). In a body no place is farther than sqrt(3)/2 spacings from a
/// particle of the lattice; the surface lies about half a spacing over the particles, so that the middle of any gap, however narrow, is at
/// least that far from them.
inline bool emptyMidpoint(double nearest2, double spacing) { return nearest2 > 0.2 * spacing * spacing; }

/// Whether a particle at d from the surfel belongs to a sheet across a gap: it is in front of the surfel by more than `above` (m), and a surfel
/// across the gap, at `gap` from this one, lies between the two.
inline bool particleAcrossGap(const Vec3d& d, const Vec3d& normal, const Vec3d& gap, double above) {
  const double height = dot(d, normal);
  return height > above && height > dot(gap, normal);
}

}  // namespace thaw
