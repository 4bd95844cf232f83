// SPDX-License-Identifier: Apache-2.0
// An elastic law on eight particles at once. An extension includes this in a source file that is compiled
// once per instruction set (thaw_instruction_sets() in CMake).
//
// A Law has
//   template<class T> static Mat3<T> stress(const LawPoint<T>&);  // Pa, first Piola stress
//   template<class T> static T energy(const LawPoint<T>&);        // Pa, energy density
// where T is LanesD; with T = double both can be tested by themselves. Laws of the library have the same
// form, and further parts (core/solid/laws/law_point.hpp).
#pragma once
#include "core/simd/lanes.hpp"
#include "core/solid/laws/elastic_law.hpp"

namespace thaw {
namespace THAW_ISA {

using thaw::LawPoint;
using thaw::logarithm;

/// Natural logarithm of each lane, by the math library that all instruction sets share.
THAW_INLINE LanesD logarithm(LanesD a) {
  alignas(64) double values[8];
  toDoubles(a, values);
  takeLogarithmsOfLanes(values);
  return loadRow(values);
}

namespace {

/// Stress and energy of a group: ElasticLaw::lanes.
template<class Law> __attribute__((flatten)) void respondLanes(const LawGroup& g) {
  LawPoint<LanesD> at{{}, loadRow(g.lambda), loadRow(g.mu), g.values, {}};
  for (int r = 0; r < 3; r++)
    at.gradient.row[r] = {loadRow(g.gradient[3 * r]), loadRow(g.gradient[3 * r + 1]),
                          loadRow(g.gradient[3 * r + 2])};
  at.f = at.gradient;
  at.f.row[0].x += LanesD(1.0), at.f.row[1].y += LanesD(1.0), at.f.row[2].z += LanesD(1.0);
  const auto shared = sharedOf<Law>(at);
  const Mat3<LanesD> stress = stressOf<Law>(at, shared);
  for (int r = 0; r < 3; r++) {
    toDoubles(stress.row[r].x, g.stress[3 * r]);
    toDoubles(stress.row[r].y, g.stress[3 * r + 1]);
    toDoubles(stress.row[r].z, g.stress[3 * r + 2]);
  }
  if (g.energy) toDoubles(energyOf<Law>(at, shared), g.energy);
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
