// SPDX-License-Identifier: Apache-2.0
// Constants of the free surface of a liquid that carries its density, and of particle shifting
// (terms/carry.hpp).
#pragma once

namespace thaw {

/// A particle is at the free surface if the smallest eigenvalue of its moment is below this value (MCL10).
/// The eigenvalue is 1 on a lattice and 0.5 in its outermost layer. If particles are displaced by up to a
/// fifth of a spacing, the mean is 0.86.
inline constexpr double surfaceMoment = 0.68;
/// Asymmetry |sum V grad W| / sum V |grad W| above which a particle is at the free surface. It is used if
/// there are no moments, and near walls, whose part of the moment is unknown. In the outermost layer of a
/// lattice it is 0.25.
inline constexpr double surfaceAsymmetry = 0.19;
/// h sum V |grad W| over the trace of the moment: 1.77 on a lattice with the default support, 1.81 in its
/// outermost layer.
inline constexpr double sizePerMoment = 1.77;
/// Shifting velocity divided by h times the strain rate, and, under tension, divided by sqrt(|p| / rho). Both
/// are per concentration gradient times h.
inline constexpr double shiftPerStrain = 20, shiftPerTension = 40;
/// A particle is next to a solid if the normal of the solid is longer than this. The length is 0.75 in the
/// first layer of a lattice.
inline constexpr double besideSolid = 0.1;

}  // namespace thaw
