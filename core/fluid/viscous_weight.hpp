// Weight of the viscosity along r. Include from code of one instruction set only through lanes.hpp's namespace.
#pragma once
#include "core/kernels/kernels.hpp"

namespace thaw {
namespace THAW_ISA {

/// sum_j V_j weight(q) (u_ij.x_ij) x_ij / r^2 / h^2 is the Laplacian of a divergence-free velocity. Monaghan 2005 eq. 8.9 has 10 |slope|
/// here, which on a lattice resists shear along its axes with .59 of the viscosity at h = 2 dx and shear along the diagonals with 1.57.
/// This weight of the same integral, falling as MCG03's viscosity kernel, has 1.06 and .89 (.95 and .96 at 3 dx); its largest eigenvalue,
/// which bounds the step, is a quarter smaller (half at 3 dx).
template<class T> THAW_INLINE T alongPair(T q2) { return T(225 / pi) * max(T(1.0) - sqrt(q2), T(0.0)); }

}  // namespace THAW_ISA
}  // namespace thaw
