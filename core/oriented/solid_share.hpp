// How much of a solid is around a place.
#pragma once

namespace thaw {

/// 1, what a particle of a solid at a distance of r (m) fills of the kernel around a place, of bodies with
/// spacing s (m): a cubic spline of a support of two spacings. Over all places of a lattice the sum is 1 to 1
/// %, .5 on a flat surface half a spacing off the outermost particles, and some .7 at these.
inline double solidShare(double r, double s) {
  const double q = r / s, far = 2 - q;
  if (!(q < 2)) return 0;
  return (q < 1 ? 1 - q * q * (1.5 - 0.75 * q) : 0.25 * far * far * far) / 3.14159265358979323846;
}

}  // namespace thaw
