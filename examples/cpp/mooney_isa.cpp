// SPDX-License-Identifier: Apache-2.0
// The law of mooney.cpp, compiled once for each instruction set.
#include "core/solid/elasticity/extension_law_lanes.hpp"

namespace mooney {
namespace THAW_ISA {
namespace {

namespace lanes = thaw::THAW_ISA;

/// Compressible Mooney-Rivlin material (C88, section 4.10): psi = a (|F|^2 - 3) + b (|cof F|^2 - 3)
/// + c (J^2 - 1) - d ln J. Its coefficients obey a + b = mu / 2, b + c = lambda / 4 and d = lambda / 2 + mu.
template<class T> struct Constants {
  T a, b, c, d;
  explicit Constants(const lanes::LawPoint<T>& at)
      : a(T(0.5 * (1 - at.values[0])) * at.mu),
        b(T(0.5 * at.values[0]) * at.mu),
        c(T(0.25) * at.lambda - b),
        d(T(0.5) * at.lambda + at.mu) {}
};

struct Law {
  template<class T> static thaw::Mat3<T> cofactor(const thaw::Mat3<T>& f) {
    return {{cross(f.row[1], f.row[2]), cross(f.row[2], f.row[0]), cross(f.row[0], f.row[1])}};
  }
  template<class T> static T square(const thaw::Mat3<T>& f) {
    return dot(f.row[0], f.row[0]) + dot(f.row[1], f.row[1]) + dot(f.row[2], f.row[2]);
  }
  template<class T> static T energy(const lanes::LawPoint<T>& at) {
    const Constants<T> k(at);
    const thaw::Mat3<T> cof = cofactor(at.f);
    const T j = dot(at.f.row[0], cof.row[0]);
    return k.a * (square(at.f) - T(3.0)) + k.b * (square(cof) - T(3.0)) + k.c * (j * j - T(1.0)) -
           k.d * lanes::logarithm(j);
  }
  template<class T> static thaw::Mat3<T> stress(const lanes::LawPoint<T>& at) {
    const Constants<T> k(at);
    const thaw::Mat3<T>& f = at.f;
    const thaw::Mat3<T> cof = cofactor(f), cubic = f * (transpose(f) * f);
    const T j = dot(f.row[0], cof.row[0]);
    return (T(2.0) * (k.a + k.b * square(f))) * f - (T(2.0) * k.b) * cubic +
           (T(2.0) * k.c * j - k.d / j) * cof;
  }
};

}  // namespace

const thaw::LawKernels& kernels();
const thaw::LawKernels& kernels() {
  static constexpr thaw::LawKernels ours = lanes::lawKernels<Law>();
  return ours;
}

}  // namespace THAW_ISA
}  // namespace mooney
