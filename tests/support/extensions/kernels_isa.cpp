// SPDX-License-Identifier: Apache-2.0
// Parts of test extensions on lanes, compiled once for each instruction set. They are a copy of the
// Neo-Hookean law, a spring with a dashpot between liquid particles, and a copy of the pairwise surface
// tension.
#include "core/fluid/laws/cohesion.hpp"
#include "core/fluid/terms/extension_pair_force_term.hpp"
#include "core/solid/elasticity/extension_law_lanes.hpp"
#include "core/solid/laws/neo_hookean.hpp"
#include "tests/support/extensions/kernels.hpp"

namespace thaw::test {
namespace THAW_ISA {
namespace {

namespace lanes = thaw::THAW_ISA;

struct NeoHookeanCopy {
  template<class T> static Mat3<T> stress(const lanes::LawPoint<T>& at) {
    return neoHookeanStress(at.f, at.lambda, at.mu);
  }
  template<class T> static T energy(const lanes::LawPoint<T>& at) {
    return neoHookeanEnergy(at.f, at.lambda, at.mu, lanes::logarithm(neoHookeanLogged(at.f)));
  }
};

/// The same with the precision of the built-in law.
struct SingleNeoHookeanCopy : NeoHookeanCopy {
  static constexpr bool doubleStress = false;
};

/// E = k a_i a_j (1 - r/h)^2 / 2 with values a, and a drag c (1 - r/h) along the velocity difference.
struct Spring {
  static constexpr bool moves = true;
  double stiffness, drag, support;
  explicit Spring(const PairConstants& c) : stiffness(c.values[0]), drag(c.values[1]), support(c.support) {}
  template<class L> THAW_INLINE lanes::PairResult<L> operator()(const lanes::PairState<L>& p) const {
    const L left = L(1.0) - p.r * L(1 / support), k = L(stiffness) * (p.own[0] * p.other[0]);
    const L c = L(drag) * left;
    return {k * left * L(1 / support) / p.r, -c, L(0.5) * k * left * left,
            c * dot3(p.vx, p.vy, p.vz, p.vx, p.vy, p.vz)};
  }
};

/// Tension (core/fluid/terms/tension.hpp) with volume times root tension, in m^3 (N/m)^1/2, as first value.
struct TensionCopy {
  static constexpr bool moves = false;
  double scale, support;
  explicit TensionCopy(const PairConstants& c)
      : scale(lanes::Cohesion::scale / std::pow(c.support, 6)), support(c.support) {}
  template<class L> THAW_INLINE lanes::PairResult<L> operator()(const lanes::PairState<L>& p) const {
    const L q = min(p.r * L(1 / support), L(1.0));
    const L strength = L(scale) * p.own[0] * p.other[0];
    lanes::PairResult<L> f;
    f.along = -(strength * lanes::Cohesion::force(q) / max(q, L(1e-6)));
    f.energy = L(support * support) * strength * lanes::Cohesion::potential(q);
    return f;
  }
};

}  // namespace

const ExtensionKernels& extensionKernelSet();
const ExtensionKernels& extensionKernelSet() {
  static constexpr ExtensionKernels set{
      lanes::lawKernels<NeoHookeanCopy>(), lanes::lawKernels<SingleNeoHookeanCopy>(),
      lanes::pairForceKernels<Spring>(), lanes::pairForceKernels<TensionCopy>()};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw::test
