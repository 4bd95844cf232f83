// SPDX-License-Identifier: Apache-2.0
// Surface tension as a pair force. Code that is compiled per instruction set includes this only through the
// namespace of lanes.hpp.
#pragma once
#include "core/kernels/kernels.hpp"

namespace thaw {
namespace THAW_ISA {

/// Surface tension as cohesion between pairs of liquid particles: central forces, so momentum and angular
/// momentum are conserved (docs/validation/stability.md, row 32). The calibration uses the continuum surface
/// tension of a pair force (TP16 eq. 14): sigma = pi/8 n^2 int r^4 F(r) dr, with F = s phi(q). The factor phi
/// = q (1-q)^2 (q - a) is repulsive below q = a.
struct Cohesion {
  static constexpr double a = 0.4;
  static constexpr double moment4 = 1.0 / 252 - a / 168;  // int_0^1 q^4 phi dq
  static constexpr double scale = 8 / (pi * moment4);
  static constexpr double potentialAt1 = 1.0 / 3 - 0.5 + 0.2 - a / 2 + 2 * a / 3 - a / 4;
  template<class L> static THAW_INLINE L force(L q) {
    const L u = L(1.0) - q;
    return q * (u * u) * (q - L(a));
  }
  template<class L> static THAW_INLINE L potential(L q) {  // integral of phi, 0 at q = 1
    return q * q * (L(-a / 2) + q * (L(1.0 / 3 + 2 * a / 3) + q * (L(-0.5 - a / 4) + L(0.2) * q))) -
           L(potentialAt1);
  }
};

}  // namespace THAW_ISA
}  // namespace thaw
