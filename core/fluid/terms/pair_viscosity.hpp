// SPDX-License-Identifier: Apache-2.0
// Viscosity between two particles.
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Returns the viscosity of a pair, from both viscosities m and liquid fractions f. Between liquids it is the
/// harmonic mean, with which the stress is continuous. A solid does not shear, so between liquid and solid it
/// is twice that of the liquid: the liquid sticks to the surface, half-way between both. In a particle that
/// melts, the front is deeper, on average in the middle, where the mean holds. The factor falls from 2 to 1
/// at a liquid fraction of 0.05. Two solids do not interact.
template<class L> THAW_INLINE L pairViscosity(L mi, L mj, L fi, L fj) {
  const L two(2.0f), mean = two * (mi * mj) / max(mi + mj, L(1e-30f));
  const L difference = max(fi - fj, fj - fi), wetter = select(fj > fi, mj, mi);
  const L sticks = max(L(20.0f) * difference - L(19.0f), L(0.0f));
  return (fi + fj - fi * fj) * (mean + sticks * (two * wetter - mean));
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
