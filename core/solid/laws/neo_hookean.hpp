// SPDX-License-Identifier: Apache-2.0
// Stable Neo-Hookean energy (SGK18 eq. 14). It is defined and smooth for every F, even if inverted.
#pragma once
#include "core/solid/laws/law_point.hpp"

namespace thaw {

/// Cofactor matrix, the derivative of det F.
template<class T> Mat3<T> cofactor(const Mat3<T>& f) {
  return {{cross(f.row[1], f.row[2]), cross(f.row[2], f.row[0]), cross(f.row[0], f.row[1])}};
}

/// Constants of the energy from Lame's constants, so that small strains follow Hooke's law (SGK18
/// section 3.4).
template<class T> struct NeoHookeanConstants {
  T lambda, mu;
  NeoHookeanConstants(const T& lameLambda, const T& lameMu)
      : lambda(lameLambda + T(5.0 / 6.0) * lameMu), mu(T(4.0 / 3.0) * lameMu) {}
};

/// Argument of the logarithm in the energy.
template<class T> T neoHookeanLogged(const Mat3<T>& f) {
  return T(0.25) * (dot(f.row[0], f.row[0]) + dot(f.row[1], f.row[1]) + dot(f.row[2], f.row[2]) + T(1.0));
}
/// psi = mu/2 (|F|^2 - 3) + lambda/2 (J - 1)^2 - 3/4 mu (J - 1) - mu/2 ln((|F|^2 + 1)/4), Pa: eq. 14 minus
/// its value at rest. `logarithm` is ln of neoHookeanLogged().
template<class T>
T neoHookeanEnergy(const Mat3<T>& f, const T& lameLambda, const T& lameMu, const T& logarithm) {
  const NeoHookeanConstants<T> k(lameLambda, lameMu);
  const T square = dot(f.row[0], f.row[0]) + dot(f.row[1], f.row[1]) + dot(f.row[2], f.row[2]),
          j = determinant(f) - T(1.0);
  return T(0.5) * k.mu * (square - T(3.0)) + T(0.5) * k.lambda * j * j - T(0.75) * k.mu * j -
         T(0.5) * k.mu * logarithm;
}

/// First Piola stress P = mu (1 - 1/(|F|^2 + 1)) F + (lambda (J - 1) - 3/4 mu) cof F (SGK18 eq. 18),
/// Pa.
template<class T> Mat3<T> neoHookeanStress(const Mat3<T>& f, const T& lameLambda, const T& lameMu) {
  const NeoHookeanConstants<T> k(lameLambda, lameMu);
  const T square = dot(f.row[0], f.row[0]) + dot(f.row[1], f.row[1]) + dot(f.row[2], f.row[2]);
  const Mat3<T> c = cofactor(f);
  const T j = dot(f.row[0], c.row[0]);
  const T a = k.mu * (T(1.0) - T(1.0) / (square + T(1.0))), b = k.lambda * (j - T(1.0)) - T(0.75) * k.mu;
  return a * f + b * c;
}

struct NeoHookeanLaw : LawDefaults {
  static constexpr const char* name = "neo-hookean";
  static constexpr const char* about =
      "stable Neo-Hookean energy of Smith et al. 2018, also for inverted particles";
  static constexpr bool doubleStress = false, resistsInversion = true, boundsStress = true;
  template<class T> static Mat3<T> stress(const LawPoint<T>& at) {
    return neoHookeanStress(at.f, at.lambda, at.mu);
  }
  template<class T> static T energy(const LawPoint<T>& at) {
    return neoHookeanEnergy(at.f, at.lambda, at.mu, logarithm(neoHookeanLogged(at.f)));
  }
  static Vec3d principal(const Vec3d& stretch, double lameLambda, double lameMu, const LawValues&) {
    const NeoHookeanConstants<double> k(lameLambda, lameMu);
    const Vec3d t{stretch.x * stretch.x, stretch.y * stretch.y, stretch.z * stretch.z};
    const double j = stretch.x * stretch.y * stretch.z, a = k.mu * (1 - 1 / (t.x + t.y + t.z + 1));
    const double b = j * (k.lambda * (j - 1) - 0.75 * k.mu);
    return {a * t.x + b, a * t.y + b, a * t.z + b};
  }
};

}  // namespace thaw
