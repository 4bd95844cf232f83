// SPDX-License-Identifier: Apache-2.0
// Kernel fraction that a solid fills at a position.
#pragma once
#include <numbers>

namespace thaw {

/// Returns the kernel fraction (1) of a solid particle at distance r (m) in a body of spacing s (m). It is a
/// cubic spline with a support of two spacings. Inside a lattice, it sums to 1 within 1 %. On a flat surface,
/// half a spacing off the outermost particles, the sum is 0.5. At the outermost particles, it is about 0.7.
inline double solidFraction(double r, double s) {
  const double q = r / s, far = 2 - q;
  if (!(q < 2)) return 0;
  return (q < 1 ? 1 - q * q * (1.5 - 0.75 * q) : 0.25 * far * far * far) / std::numbers::pi;
}

}  // namespace thaw
