// Pressure that keeps the volume of liquids (Bender & Koschier 2015/2017, DFSPH), as the Lagrange multiplier
// of filling <= full: with it steps are limited by speed and not by sound.
//
// The scheme is that of leap-frog under constraints (Andersen 1983, RATTLE). At the end of a step the
// velocity is freed of compression (divergence solve); then the impulse is found with which the next half
// kick and drift end at full fillings (density solve). That impulse is kept (Continuum::pressureKick) and is
// the first thing the next step adds. Both need the neighbours of the places where the particles are, so that
// a step searches once.
//
// "Full" is not the lattice's 1 but the largest filling that its layers come through as they slide over each
// other (slidingLatticeSum; 1.003 at h = 2 dx): liquid that fills its vessel has no room to give way, and
// with 1 it would jam as sand does. Poiseuille flow (benchmark poiseuille with H/dx = 20) was then at .79 of
// its rate, and at .2 with steps of a quarter.
//
// Both are the problem: pressures k >= 0 (Pa s) whose impulses -sum_i V_i k_i d delta_i/dx leave no predicted
// compression e <= 0, and k = 0 where e < 0: a convex one, whose matrix V D M^-1 D^T V is symmetric. It is
// never formed. It is solved by Jacobi steps, cut at 0, with Nesterov's momentum (Nesterov 1983; restarted
// where it points uphill, O'Donoghue & Candes 2015). Every decision rests on integer sums over all ranks: the
// number of iterations is the same on any number of them.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Adds Continuum::pressureKick to the velocities; what it takes from the kinetic energy is booked as
/// dissipated.
void addPressureKick(World& world);

/// Both solves. dt (s): of the step that ends now; the next one's is in the clock. Needs the neighbour lists,
/// ghosts, records and wall contacts of this step's evaluation. Guarantees: velocities without compression,
/// and pressureKick, holding, steadying and pressure for what comes. Impulse and work of walls are in the
/// ledger. Collective.
void findPressure(World& world, Halos halos, StepTools& tools, double dt);

}  // namespace thaw
