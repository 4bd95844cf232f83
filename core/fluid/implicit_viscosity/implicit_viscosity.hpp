// Viscosity without a limit to the step (after Weiler, Koschier, Brand, Bender 2018, "A physically consistent
// implicit viscosity solver for SPH fluids"): backward Euler, a linear system for the velocities solved by
// conjugate gradients.
//
// The leap-frog's velocity v lives at half steps: v' = v + dt (F + F_visc) / m, F the other forces. F_visc =
// -L (v') - W (v' - v_wall) is taken at the new velocity: (M + dt L + dt W) v' = M v + dt F + dt W v_wall. L
// is the operator of the explicit pair sum, with the harmonic mean of the viscosities, W the walls' drag:
// both symmetric and not negative, so the matrix is symmetric and positive definite whatever the step and the
// contrast of viscosity. F_visc then is a force as any other: a sum over pairs, equal and opposite along the
// line of two particles. So momentum and angular momentum are kept to rounding, however far the iteration
// got. A steady state is that of the explicit step. The books take the whole kick's loss with the step in
// which the force is found, as for explicit forces: they are ahead by the half kick to come. With long steps
// that is more, but it does not add up.
//
// Differences to the paper: the pair sum is thaw's (no factor of dimension and artificial scaling; walls by
// their tables); solid particles, bonded or not, are unknowns, and clamped and driven ones known velocities,
// so that both ends of every pair feel it; the iteration ends when its error is small beside what viscosity
// changes, not beside the velocity.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Adds viscous forces (N) to Continuum::force and what they take (W) to dissipation, and books the walls'
/// and clamps' share in the ledger. After all other forces, with neighbour lists, records and wall contacts
/// of now; over WallContext::span. Iterates until the error in |.|_M is at most Numerics::viscosityTolerance
/// of the change of velocity by viscosity, or Numerics::viscosityIterations times
/// (Counters::viscousUnfinished). Collective; the same bits on any number of ranks.
void addImplicitViscosity(World& world, Halos halos, StepTools& tools, const PairSums& sums,
                          const WallContext& walls);

}  // namespace thaw
