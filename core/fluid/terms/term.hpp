// SPDX-License-Identifier: Apache-2.0
// Common parts of the pair-sum terms. sweep() (core/fluid/pair_sums/sweep.hpp) calls `load`, `pair` and
// `finish` of a term; conduction.hpp is a short example. Compiled once per instruction set. Within a term d
// is the position difference own - other in support radii, and V a volume in h^3. `finish` restores units of
// length.
#pragma once
#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/fluid/pair_sums/sweep.hpp"
#include "core/kernels/kernels.hpp"
#include "core/simd/wide.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Heat flow from j to i with the harmonic mean of the conductivities (CM99 eq. 36); VV:
/// product of both volumes. For j it is the exact negative.
template<class Real>
THAW_INLINE Lanes<Real> conducted(Lanes<Real> VV, const Lanes4<Real>& i, const Lanes4<Real>& j,
                                  Lanes<Real> laplace) {
  using L = Lanes<Real>;
  const L k = L(2.0) * i.d * j.d / max(i.d + j.d, L(1e-30));
  return VV * k * laplace * (j.c - i.c);
}

template<class Real> const Record<Real>* records(const void* p) {
  return static_cast<const Record<Real>*>(p);
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
