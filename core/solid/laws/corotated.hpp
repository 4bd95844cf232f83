// SPDX-License-Identifier: Apache-2.0
// Corotated linear elasticity: mu |F - R|^2 + lambda/2 tr(R^T F - 1)^2 with the rotation R nearest to F
// (MG04; invertible form: ITF04). The stress is linear in stretch, so it does not soften in compression.
// Particles do not stay inverted, since R is a proper rotation even for det F < 0.
#pragma once
#include "core/solid/laws/neo_hookean.hpp"

namespace thaw {

template<class T> T doubleDot(const Mat3<T>& a, const Mat3<T>& b) {
  return dot(a.row[0], b.row[0]) + dot(a.row[1], b.row[1]) + dot(a.row[2], b.row[2]);
}

/// One step of Newton's iteration R <- (R + R^-T)/2 for the nearest rotation. It keeps the sign of the
/// determinant and converges quadratically (H86).
template<class T> Mat3<T> towardsRotation(const Mat3<T>& r) {
  const Mat3<T> c = cofactor(r);
  return T(0.5) * (r + (T(1.0) / dot(r.row[0], c.row[0])) * c);
}
/// The iteration converges to the nearest rotation if det F exceeds this fraction of (|F|^2 / 3)^(3/2), its
/// value for a scaled rotation.
inline constexpr double newtonsShare = 0.05;
inline constexpr int newtonsSteps = 20;
/// Squared change below which the iterate is exact up to rounding, since the next change would be the
/// square of this one.
inline constexpr double newtonsEnd = 1e-16;

/// Returns the rotation R (det R = +1) that maximises tr(R^T F), from the polar decomposition. If det F < 0,
/// the smallest singular value counts as negative. Any F is valid, zero included.
Mat3d nearestRotation(const Mat3d& f);
/// The same for one lane. Arrays are by [row][column][lane].
void nearestRotationOfLane(const double f[9][8], int lane, double rotation[9][8]);

/// psi (Pa) and first Piola stress P = 2 mu (F - R) + lambda tr(R^T F - 1) R (Pa) for a given R.
template<class T> T corotatedEnergy(const Mat3<T>& f, const Mat3<T>& r, const T& lambda, const T& mu) {
  const Mat3<T> d = f - r;
  const T t = doubleDot(r, d);
  return mu * doubleDot(d, d) + T(0.5) * lambda * t * t;
}
template<class T> Mat3<T> corotatedStress(const Mat3<T>& f, const Mat3<T>& r, const T& lambda, const T& mu) {
  const Mat3<T> d = f - r;
  return (mu + mu) * d + (lambda * doubleDot(r, d)) * r;
}

struct CorotatedLaw : LawDefaults {
  static constexpr const char* name = "corotated";
  static constexpr const char* about =
      "linear in stretch and invariant to rotation, also for inverted particles (Mueller and Gross 2004)";
  static constexpr bool resistsInversion = true, boundsStress = true;  // F - R cancels at small strains
  template<class T> static Mat3<T> shared(const LawPoint<T>& at) { return nearestRotation(at.f); }
  template<class T> static Mat3<T> stress(const LawPoint<T>& at, const Mat3<T>& rotation) {
    return corotatedStress(at.f, rotation, at.lambda, at.mu);
  }
  template<class T> static T energy(const LawPoint<T>& at, const Mat3<T>& rotation) {
    return corotatedEnergy(at.f, rotation, at.lambda, at.mu);
  }
  static Vec3d principal(const Vec3d& stretch, double lambda, double mu, const LawValues&) {
    const double p = lambda * (stretch.x + stretch.y + stretch.z - 3);
    return {stretch.x * (p + 2 * mu * (stretch.x - 1)), stretch.y * (p + 2 * mu * (stretch.y - 1)),
            stretch.z * (p + 2 * mu * (stretch.z - 1))};
  }
};

}  // namespace thaw
