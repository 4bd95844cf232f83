// Corotated linear elasticity: mu |F - R|^2 + lambda/2 tr(R^T F - 1)^2 with the rotation R nearest to F
// (Mueller & Gross 2004; its invertible form: Irving, Teran, Fedkiw 2004). Linear in stretch, so it neither
// softens in compression nor stays inverted: R is a proper rotation even where det F < 0.
#pragma once
#include "core/solid/laws/neo_hookean.hpp"

namespace thaw {

template<class T> T doubleDot(const Mat3<T>& a, const Mat3<T>& b) {
  return dot(a.row[0], b.row[0]) + dot(a.row[1], b.row[1]) + dot(a.row[2], b.row[2]);
}

/// A step of Newton's iteration R <- (R + R^-T)/2 for the rotation nearest to what it begins with: keeps the
/// sign of the determinant, converges quadratically (Higham 1986).
template<class T> Mat3<T> towardsRotation(const Mat3<T>& r) {
  const Mat3<T> c = cofactor(r);
  return T(0.5) * (r + (T(1.0) / dot(r.row[0], c.row[0])) * c);
}
/// It leads to the wanted rotation where det F is more than this share of (|F|^2 / 3)^(3/2), which is det F
/// of a rotation times a number.
inline constexpr double newtonsShare = 0.05;
inline constexpr int newtonsSteps = 20;
/// Square of the last change with which an iterate has no error above rounding: the next change would be its
/// square.
inline constexpr double newtonsEnd = 1e-16;

/// The rotation R (det R = +1) that maximises tr(R^T F): of the polar decomposition; where det F < 0 the
/// smallest singular value counts as negative. Any F, zero included.
Mat3d nearestRotation(const Mat3d& f);

/// psi, Pa, and first Piola stress P = 2 mu (F - R) + lambda tr(R^T F - 1) R, Pa, with R known.
template<class T> T corotatedEnergy(const Mat3<T>& f, const Mat3<T>& r, const T& lambda, const T& mu) {
  const Mat3<T> d = f - r;
  const T t = doubleDot(r, d);
  return mu * doubleDot(d, d) + T(0.5) * lambda * t * t;
}
template<class T> Mat3<T> corotatedStress(const Mat3<T>& f, const Mat3<T>& r, const T& lambda, const T& mu) {
  const Mat3<T> d = f - r;
  return (mu + mu) * d + (lambda * doubleDot(r, d)) * r;
}
/// Principal Kirchhoff stresses of these principal stretches, Pa.
inline Vec3d corotatedPrincipal(const Vec3d& stretch, double lambda, double mu) {
  const double p = lambda * (stretch.x + stretch.y + stretch.z - 3);
  return {stretch.x * (p + 2 * mu * (stretch.x - 1)), stretch.y * (p + 2 * mu * (stretch.y - 1)),
          stretch.z * (p + 2 * mu * (stretch.z - 1))};
}

}  // namespace thaw
