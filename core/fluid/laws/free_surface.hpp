// SPDX-License-Identifier: Apache-2.0
// Free surface of a liquid that carries its density, and particle shifting, which depends on it
// (terms/carry.hpp).
#pragma once

namespace thaw {

/// Smallest eigenvalue of the moment below which a particle is at the free surface (MCL10). It is 1 on a
/// lattice and 0.5 in its outermost layer. Where particles are moved by up to a fifth of a spacing, its mean
/// is 0.86.
inline constexpr double surfaceMoment = 0.68;
/// Asymmetry |sum V grad W| / sum V |grad W| above which a particle is at the free surface. It is used
/// without moments, and near walls, whose part of the moment is unknown. The outermost layer of a lattice has
/// 0.25.
inline constexpr double surfaceAsymmetry = 0.19;
/// h sum V |grad W| over the trace of the moment: 1.77 on a lattice with the default support, 1.81 in its
/// outermost layer.
inline constexpr double sizePerMoment = 1.77;
/// Shifting velocity over h times the strain rate, and over sqrt(|p| / rho) under tension, each per
/// concentration gradient.
inline constexpr double shiftPerStrain = 20, shiftPerTension = 40;
/// Length of the normal of a solid above which it is adjacent; 0.75 in the first layer of a lattice.
inline constexpr double besideSolid = 0.1;

}  // namespace thaw
