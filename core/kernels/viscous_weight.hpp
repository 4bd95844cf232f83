// SPDX-License-Identifier: Apache-2.0
// Weight of the pairwise viscosity along r.
#pragma once
#include <numbers>

#include "core/kernels/kernels.hpp"

namespace thaw {

/// Weight scale (1 - q) of pairwise viscosity, q = r / h. The sum over j of V_j weight(q) (u_ij.x_ij) x_ij /
/// r^2 / h^2 is the Laplacian of a divergence-free velocity. viscousWeight() (core/kernels/lattice.hpp)
/// returns the scale, 225 / pi in the continuum. The weight of M05 eq. 8.9 is 10 |slope|. With that weight at
/// h = 2 dx, a lattice has 0.59 of the viscosity in shear along its axes. Along its diagonals it has 1.57.
struct ViscousWeight {
  double scale = 225 / std::numbers::pi;
};

namespace THAW_ISA {

template<class T> THAW_INLINE T weightAt(T scale, T q) { return scale * max(T(1.0) - q, T(0.0)); }
/// Weight as a function of q^2.
template<class T> THAW_INLINE T alongPair(T scale, T q2) { return weightAt(scale, sqrt(q2)); }

}  // namespace THAW_ISA
}  // namespace thaw
