// SPDX-License-Identifier: Apache-2.0
// An elastic law on eight particles at once. An extension includes this in a source file that is compiled
// once per instruction set (thaw_instruction_sets() in CMake).
//
// A Law has
//   template<class T> static Mat3<T> stress(const LawPoint<T>&);  // Pa, first Piola stress
//   template<class T> static T energy(const LawPoint<T>&);        // Pa, energy density
// where T is LanesD. With T = double, both functions can be tested separately. A Law may have the other parts
// in core/solid/laws/law_point.hpp. With doubleStress = false or doubleEnergy = false, T is LanesF if bonds
// are in single precision.
#pragma once
#include "core/solid/elasticity/deformation_lanes.hpp"

namespace thaw {
namespace THAW_ISA {

using thaw::LawPoint;
using thaw::logarithm;

namespace {

template<class Law, class Real> THAW_INLINE void respondLanesIn(const LawGroup& g) {
  const Mat3<Lanes<Real>> gradient = loadMatrix<Real>(g.gradient);
  Mat3<Lanes<Real>> stress;
  respondInline<Law, Real>({g.lambda, g.mu, gradient, addIdentity(gradient), g.energy != nullptr}, g.values,
                           stress, g.energy);
  storeMatrix<Real>(stress, g.stress);
}
/// Computes stress and energy of a group, with the same bits as the bond loop.
template<class Law> __attribute__((flatten)) void respondLanes(const LawGroup& g) {
  g.single ? respondLanesIn<Law, float>(g) : respondLanesIn<Law, double>(g);
}

/// A list of one law, which the loop inlines. Other laws are called.
template<class Law> struct OneLaw {
  template<class F> static THAW_INLINE bool at(const ElasticLaw& law, F&& f) {
    return law.kernels.lanes == respondLanes<Law> ? (f.template operator()<Law>(), true) : false;
  }
};

/// The functions of a law on this instruction set: ElasticLaw::kernels.
template<class Law> constexpr LawKernels lawKernels() {
  return {respondLanes<Law>, deformation<OneLaw<Law>>};
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
