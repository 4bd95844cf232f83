// SPDX-License-Identifier: Apache-2.0
// Smoothing kernels in 3D in units of the support radius: q = r / h. They are zero for q >= 1. T is double or
// Lanes<Real>. Each takes q and its square; an unused argument costs nothing.
//   w(q)       W   = w(q) / h^3
//   slope(q)   grad W = slope(q) * x_hat_q / h^4 with x in units of h: slope = w'(q) / q, negative
//   laplace(q) kernel of the Laplacian of a field, sum_j V_j (a_j - a_i) laplace(q) / h^5; see each kernel
// Code that is compiled per instruction set includes this only through the namespace of lanes.hpp.
#pragma once
#include <cmath>
#include <numbers>

#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {

THAW_INLINE double sqrt(double a) { return __builtin_sqrt(a); }
THAW_INLINE double max(double a, double b) { return a > b ? a : b; }
THAW_INLINE double select(bool m, double a, double b) { return m ? a : b; }
THAW_INLINE double fma(double a, double b, double c) { return __builtin_fma(a, b, c); }

using std::numbers::pi;

/// Adds overloads that take only the square q^2.
template<class Kernel> struct OfSquare {
  template<class T> static THAW_INLINE T w(T q2) { return Kernel::w(sqrt(q2), q2); }
  template<class T> static THAW_INLINE T slope(T q2) { return Kernel::slope(sqrt(q2), q2); }
  template<class T> static THAW_INLINE T laplace(T q2) { return Kernel::laplace(sqrt(q2), q2); }
};

/// Wendland C2 function (W95), support h: positive Fourier transform, no pairing
/// (docs/validation/stability.md, row 6). The default kernel.
struct WendlandC2 : OfSquare<WendlandC2> {
  using OfSquare<WendlandC2>::w, OfSquare<WendlandC2>::slope, OfSquare<WendlandC2>::laplace;
  template<class T> static THAW_INLINE T w(T q, T) {
    const T u = max(T(1.0) - q, T(0.0)), u2 = u * u;
    return T(21 / (2 * pi)) * (u2 * u2) * fma(T(4.0), q, T(1.0));
  }
  template<class T> static THAW_INLINE T slope(T q, T) {
    const T u = max(T(1.0) - q, T(0.0));
    return T(-210 / pi) * (u * u * u);
  }
  static constexpr double laplacePerSlope = -2;
  /// Brookshaw's form 2 |w'| / q: second derivative from first derivatives.
  template<class T> static THAW_INLINE T laplace(T q, T q2) { return T(laplacePerSlope) * slope(q, q2); }
};

/// Kernels of MCG03: poly6 for densities, spiky for gradients, the viscosity kernel for
/// Laplacians.
struct Mcg03 : OfSquare<Mcg03> {
  using OfSquare<Mcg03>::w, OfSquare<Mcg03>::slope, OfSquare<Mcg03>::laplace;
  template<class T> static THAW_INLINE T w(T, T q2) {
    const T u = max(T(1.0) - q2, T(0.0));
    return T(315 / (64 * pi)) * (u * u * u);
  }
  template<class T> static THAW_INLINE T slope(T q, T) {
    const T u = max(T(1.0) - q, T(0.0));
    return T(-45 / pi) * (u * u) / max(q, T(1e-6));
  }
  template<class T> static THAW_INLINE T laplace(T q, T) { return T(45 / pi) * max(T(1.0) - q, T(0.0)); }
};

/// Cubic spline of ML85 with its support scaled to h.
struct CubicSpline : OfSquare<CubicSpline> {
  using OfSquare<CubicSpline>::w, OfSquare<CubicSpline>::slope, OfSquare<CubicSpline>::laplace;
  template<class T> static THAW_INLINE T w(T q, T) {
    const T u = max(T(1.0) - q, T(0.0)), v = max(T(0.5) - q, T(0.0));
    return T(16 / pi) * (u * u * u - T(4.0) * (v * v * v));
  }
  template<class T> static THAW_INLINE T slope(T q, T) {
    const T u = max(T(1.0) - q, T(0.0)), v = max(T(0.5) - q, T(0.0));
    return T(-48 / pi) * (u * u - T(4.0) * (v * v)) / max(q, T(1e-6));
  }
  template<class T> static THAW_INLINE T laplace(T q, T q2) { return T(-2.0) * slope(q, q2); }
};

}  // namespace THAW_ISA
}  // namespace thaw
