// SPDX-License-Identifier: Apache-2.0
// An extension's elastic law on eight particles at once. An extension includes this in a source file that is
// compiled once per instruction set (thaw_instruction_sets() in CMake).
//
// A Law has
//   template<class T> static Mat3<T> stress(const LawPoint<T>&);  // Pa, first Piola stress
//   template<class T> static T energy(const LawPoint<T>&);        // Pa, energy density
// where T is LanesD; with T = double both can be tested by themselves.
#pragma once
#include <cmath>

#include "core/materials/extension_law.hpp"
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

template<class T> struct LawPoint {
  Mat3<T> f;     ///< deformation gradient
  T lambda, mu;  ///< Pa, Lame's constants
  const LawValues& values;
};

/// Natural logarithm of each lane, by the math library that all instruction sets share.
THAW_INLINE LanesD logarithm(LanesD a) {
  alignas(64) double values[8];
  toDoubles(a, values);
  takeLogarithmsOfLanes(values);
  return loadRow(values);
}
inline double logarithm(double a) { return std::log(a); }

/// Stress and energy of a group: ExtensionLaw::lanes.
template<class Law> __attribute__((flatten)) void respondLanes(const LawGroup& g) {
  LawPoint<LanesD> at{{}, loadRow(g.lambda), loadRow(g.mu), g.values};
  for (int r = 0; r < 3; r++)
    at.f.row[r] = {loadRow(g.gradient[3 * r]), loadRow(g.gradient[3 * r + 1]),
                   loadRow(g.gradient[3 * r + 2])};
  at.f.row[0].x += LanesD(1.0), at.f.row[1].y += LanesD(1.0), at.f.row[2].z += LanesD(1.0);
  const Mat3<LanesD> stress = Law::stress(at);
  for (int r = 0; r < 3; r++) {
    toDoubles(stress.row[r].x, g.stress[3 * r]);
    toDoubles(stress.row[r].y, g.stress[3 * r + 1]);
    toDoubles(stress.row[r].z, g.stress[3 * r + 2]);
  }
  if (g.energy) toDoubles(Law::energy(at), g.energy);
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
