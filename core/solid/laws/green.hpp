// SPDX-License-Identifier: Apache-2.0
// Green strain with Hooke's law (St. Venant-Kirchhoff; MKN04, K05). It is exact under rotation, and softens
// when compressed to less than 0.577 of the length. Only the volume force resists inversion
// (docs/validation/stability.md, rows 4 and 5).
#pragma once
#include "core/solid/laws/law_point.hpp"

namespace thaw {

/// eps = (F^T F - 1)/2 of F = 1 + grad u, computed from grad u to avoid cancellation at small strains.
template<class T> [[gnu::always_inline]] inline Sym3<T> greenStrain(const Mat3<T>& gradU) {
  const Vec3<T>&a = gradU.row[0], &b = gradU.row[1], &c = gradU.row[2];
  const T h(0.5);
  return {a.x + h * (a.x * a.x + b.x * b.x + c.x * c.x),
          b.y + h * (a.y * a.y + b.y * b.y + c.y * c.y),
          c.z + h * (a.z * a.z + b.z * b.z + c.z * c.z),
          h * (a.y + b.x + (a.x * a.y + b.x * b.y + c.x * c.y)),
          h * (b.z + c.y + (a.y * a.z + b.y * b.z + c.y * c.z)),
          h * (a.z + c.x + (a.x * a.z + b.x * b.z + c.x * c.z))};
}

/// Hooke's law: lambda tr(e) 1 + 2 mu e, Pa.
template<class T> Sym3<T> hooke(const Sym3<T>& e, const T& lambda, const T& mu) {
  const T p = lambda * trace(e), m = mu + mu;
  return {p + m * e.xx, p + m * e.yy, p + m * e.zz, m * e.xy, m * e.yz, m * e.xz};
}

/// a s for a symmetric s.
template<class T> [[gnu::always_inline]] inline Mat3<T> times(const Mat3<T>& a, const Sym3<T>& s) {
  return {{s * a.row[0], s * a.row[1], s * a.row[2]}};
}

/// psi = e : hooke(e) / 2, Pa.
template<class T> T greenEnergy(const Sym3<T>& strain, const T& lambda, const T& mu) {
  return T(0.5) * doubleDot(strain, hooke(strain, lambda, mu));
}
/// First Piola stress P = F hooke(e), Pa.
template<class T> Mat3<T> greenStress(const Mat3<T>& f, const Sym3<T>& strain, const T& lambda, const T& mu) {
  return times(f, hooke(strain, lambda, mu));
}
/// Returns the lanes where some principal stretch is below sqrt(1/3), as bits. 3 E + 1 = 3/2 C - 1/2 then has
/// an eigenvalue < 0, which its leading minors detect. The test is skipped if |E| < 1/3, which excludes such
/// eigenvalues.
template<class T> [[gnu::always_inline]] inline unsigned greenSoftened(const Sym3<T>& e) {
  const T square = e.xx * e.xx + e.yy * e.yy + e.zz * e.zz + T(2) * (e.xy * e.xy + e.yz * e.yz + e.xz * e.xz);
  if (!any(T(1.0 / 9) < square)) return 0;
  const T one(1), three(3);
  const T xx = three * e.xx + one, yy = three * e.yy + one, zz = three * e.zz + one;
  const T xy = three * e.xy, yz = three * e.yz, xz = three * e.xz;
  const T second = xx * yy - xy * xy, third = zz * second - xx * yz * yz - yy * xz * xz + (xy + xy) * yz * xz;
  const T least = min(xx, min(second, third));
  unsigned lanes = 0;
  for (int l = 0; l < 8; l++) lanes |= static_cast<unsigned>(least[l] < 0) << l;
  return lanes;
}

struct GreenLaw : LawDefaults {
  static constexpr const char* name = "green";
  static constexpr const char* about = "Green strain with Hooke's law, as in Mueller et al. 2004";
  static constexpr bool doubleStress = false, doubleEnergy = false, boundsStress = true;
  template<class T> static Sym3<T> shared(const LawPoint<T>& at) { return greenStrain(at.gradient); }
  template<class T> static Mat3<T> stress(const LawPoint<T>& at, const Sym3<T>& strain) {
    return greenStress(at.f, strain, at.lambda, at.mu);
  }
  template<class T> static T energy(const LawPoint<T>& at, const Sym3<T>& strain) {
    return greenEnergy(strain, at.lambda, at.mu);
  }
  /// t (lambda tr(e) + 2 mu e) with t = stretch^2, e = (t - 1)/2.
  static Vec3d principal(const Vec3d& stretch, double lambda, double mu, const LawValues&) {
    const Vec3d t{stretch.x * stretch.x, stretch.y * stretch.y, stretch.z * stretch.z};
    const double p = 0.5 * lambda * (t.x + t.y + t.z - 3);
    return {t.x * (p + mu * (t.x - 1)), t.y * (p + mu * (t.y - 1)), t.z * (p + mu * (t.z - 1))};
  }
  static double stiffening(double largestStretch2, const LawValues&) { return 1.5 * largestStretch2 - 0.5; }
  template<class T> static unsigned softened(const LawPoint<T>&, const Sym3<T>& strain) {
    return greenSoftened(strain);
  }
};

}  // namespace thaw
