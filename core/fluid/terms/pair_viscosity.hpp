// SPDX-License-Identifier: Apache-2.0
// Viscosity between two particles.
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Returns the viscosity of a pair from the viscosities m and liquid fractions f. It is the harmonic mean,
/// which makes the stress continuous. Two solids do not interact. For the viscosity of solids see
/// core/fluid/laws/sticking_viscosity.hpp.
template<class L> THAW_INLINE L pairViscosity(L mi, L mj, L fi, L fj) {
  return (fi + fj - fi * fj) * (L(2.0f) * mi * mj / max(mi + mj, L(1e-30f)));
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
