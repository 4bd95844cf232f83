// SPDX-License-Identifier: Apache-2.0
// Correction of the pairwise viscosity for the arrangement of the neighbours.
#pragma once

namespace thaw {

/// Sums over the neighbours j of a liquid particle with weights a = V_j weight / d^2 (viscous_weight.hpp).
/// Here d is the position difference in support radii, and u the velocity difference (m/s).
struct ViscousNeighbours {
  double relativeDensity = 0;  ///< summed, with no-slip walls
  double wallShear = 0;        ///< share of no-slip walls in the dissipation (WallIntegrals::shear)
  double second[6] = {};       ///< a d d: XX YY ZZ XY YZ XZ
  double velocity[9] = {};     ///< a u d, by rows of u, m/s
  double fourth[21] = {};      ///< a p_k p_l for l >= k, p: products of d in the order of `second`
};

/// Returns the factor by which to multiply the particle's viscosity. Its pairs then dissipate as much as the
/// liquid: 2 mu D:D per volume, with the strain rate D. In a linear flow pairs dissipate mu / 2 sum_j a (d.D
/// d)^2. On a lattice this depends on the directions of D. It is 0.89 to 1.06 of the exact value at rest.
/// While layers slide past each other, it is 0.54 to 1.26. D is fitted to the velocities of the neighbours by
/// least squares with the same weights; its trace is removed. Next to no-slip walls, pairs dissipate the
/// part that walls do not. If neighbours are missing, close to a free surface or a slip wall, the factor
/// is 1. It lies between 1/2 and `most`.
double viscosityFactor(const ViscousNeighbours& sums, double most);

}  // namespace thaw
