// SPDX-License-Identifier: Apache-2.0
// Implicit viscosity without a step limit (after WKBB18). Backward Euler gives a linear system for the
// velocities, which conjugate gradients solve.
//
// The leap-frog velocity v lives at half steps: v' = v + dt (F + F_visc) / m, F the other forces. F_visc = -L
// (v') - W (v' - v_wall) is taken at the new velocity: (M + dt L + dt W) v' = M v + dt F + dt W v_wall. L is
// the operator of the explicit pair sum, W the drag of walls. L and W are symmetric and positive
// semidefinite, so the matrix is symmetric positive definite for any step and viscosity contrast. F_visc is a
// sum of pair forces, equal and opposite along the line between two particles. Momentum and angular momentum
// are thus conserved to rounding after any number of iterations. The steady state equals that of the explicit
// step. The energy budget records the loss of the whole kick in the step of the force evaluation, as for
// explicit forces. The recorded loss thus leads by half a kick. The lead grows with the step but does not
// accumulate.
//
// Differences to the paper: the pair sum is that of the explicit form (no dimension factor or artificial
// scaling, and walls by tables). Solid particles, bonded or not, are unknowns. Clamped and driven particles
// are known velocities. Both ends of every pair thus receive the force. The iteration ends when its error is
// small relative to the change by viscosity, not relative to the velocity.
#pragma once
#include <cstddef>

#include "core/flow/implicit_viscosity/viscous_work.hpp"
#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/halo/halos.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/particles/joint_motion.hpp"
#include "core/time/phase_times.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// The data of a step that the solver uses in addition to WallContext.
struct ViscosityView {
  const NeighbourLists& neighbours;
  const PairKernels& kernels;
  std::size_t ghostRoom;  ///< rows reserved for ghosts between the owned rows and the dummy row
  const WallContacts& wallContacts;
  ViscousWork& viscous;
  PhaseTimes& times;
  JointMotion* joint = nullptr;  ///< rigid pieces; null: all particles move on their own
};

/// Adds viscous forces (N) to Continuum::force and their loss (W) to dissipation. Records the part of walls
/// and clamps in the ledger. The kick lasts WallContext::span. Iterates until the error in |.|_M is at most
/// Numerics::viscosityTolerance times the velocity change by viscosity, or for Numerics::viscosityIterations
/// iterations (Counters::viscousUnfinished). Requires: all other forces, and current neighbour lists, records
/// and wall contacts. Collective; the same bits on any number of ranks.
void addImplicitViscosity(const ViscosityView& view, Halos halos, const PairSums& sums,
                          const WallContext& walls);

}  // namespace thaw
