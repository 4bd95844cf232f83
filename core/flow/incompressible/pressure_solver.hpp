// SPDX-License-Identifier: Apache-2.0
// Pressure solver for incompressible liquids (DFSPH, BK17). The pressure is the
// Lagrange multiplier of the constraint relative density <= target. The flow speed thus limits the step, and
// the speed of sound does not.
//
// The scheme is a constrained leap-frog (RATTLE, A83). At the end of a step the divergence solve
// removes compression rates from the velocity. The density solve then finds the impulse with which the next
// half kick and drift end at the target density. That impulse is stored (Continuum::pressureImpulse) and
// applied at the start of the next step. Both solves use the neighbours of the current positions, so a step
// has one search.
//
// The target is not 1 but the largest relative density of sliding lattice layers (slidingLatticeSum; 1.003 at
// h = 2 dx). A liquid that fills its vessel cannot expand. With a target of 1 it would jam like sand.
// Poiseuille flow (benchmark poiseuille with H/dx = 20) would have 0.79 of the exact flow rate, and 0.2 with
// a quarter of the step.
//
// Both solves have the same form. They find pressure impulses k >= 0 (Pa s) with the impulses -sum_i V_i k_i
// D_i. D_i is the gradient of delta_i, corrected inside the liquid (gradient_correction.hpp). The predicted
// compression e is then at most 0, and k = 0 where e < 0. The problem is convex; its matrix V D M^-1 D^T V is
// symmetric and never formed. It is solved by Jacobi steps, clamped at 0, with Nesterov's momentum (N83),
// restarted where it points uphill (OC15). All decisions rest on integer sums over all ranks.
// Iterations therefore do not depend on the number of ranks.
#pragma once
#include "core/flow/incompressible/pressure_system.hpp"

namespace thaw {

/// Adds Continuum::pressureImpulse to the velocities; the loss of kinetic energy is recorded as dissipated.
void addPressureImpulse(Continuum& particles);

/// Runs both solves. dt (s): the step that ends now; the clock has the next one. Requires: neighbour lists,
/// ghosts, records and wall contacts of this step's evaluation. Ensures: velocities without compression,
/// updated pressureImpulse, densityPressure and divergencePressure, and impulse and work of walls in the
/// ledger. Collective.
void findPressure(const PressureSystem& system, double dt);

}  // namespace thaw
