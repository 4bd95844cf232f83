// SPDX-License-Identifier: Apache-2.0
// The pair function of attraction.cpp, compiled once for each instruction set.
#include "core/fluid/terms/extension_pair_force_term.hpp"

namespace attraction {
namespace THAW_ISA {
namespace {

namespace lanes = thaw::THAW_ISA;

/// E = -k (1 - r/h)^3 s_i s_j with the strength k (J) of the scene, and s = 1 for one liquid, -1 for another.
struct Law {
  static constexpr bool moves = false;
  double strength, support;
  explicit Law(const thaw::PairConstants& c) : strength(c.values[0]), support(c.support) {}
  template<class L> THAW_INLINE lanes::PairResult<L> operator()(const lanes::PairState<L>& p) const {
    const L left = L(1.0) - p.r * L(1 / support), k = L(strength) * p.own[0] * p.other[0];
    lanes::PairResult<L> f;
    f.energy = -k * left * left * left;
    f.along = L(-3 / support) * k * left * left / p.r;  // -(dE/dr) / r
    return f;
  }
};

}  // namespace

const thaw::PairForceKernels& kernels();
const thaw::PairForceKernels& kernels() {
  static constexpr thaw::PairForceKernels ours = lanes::pairForceKernels<Law>();
  return ours;
}

}  // namespace THAW_ISA
}  // namespace attraction
