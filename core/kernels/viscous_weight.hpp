// SPDX-License-Identifier: Apache-2.0
// Weight of the viscosity along r, and its only evaluation.
#pragma once
#include <numbers>

#include "core/kernels/kernels.hpp"

namespace thaw {

/// scale (1 - q), q = r / h: sum_j V_j weight(q) (u_ij.x_ij) x_ij / r^2 / h^2 is the Laplacian of a
/// divergence-free velocity, with the scale from viscousWeight() (core/kernels/lattice.hpp). In the continuum
/// it is 225 / pi. M05 eq. 8.9 has 10 |slope| instead. At h = 2 dx a lattice then resists shear along its
/// axes with 0.59 of the viscosity, along its diagonals with 1.57.
struct ViscousWeight {
  double scale = 225 / std::numbers::pi;
};

namespace THAW_ISA {

template<class T> THAW_INLINE T weightAt(T scale, T q) { return scale * max(T(1.0) - q, T(0.0)); }
/// Weight as a function of q^2.
template<class T> THAW_INLINE T alongPair(T scale, T q2) { return weightAt(scale, sqrt(q2)); }

}  // namespace THAW_ISA
}  // namespace thaw
