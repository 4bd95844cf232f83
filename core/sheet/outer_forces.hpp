// Forces on a sheet from outside: weight, wind, wrap, brushes, obstacles (DS section 3.1); and the books of
// what holds it.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Velocities (m/s) at the time of the forces, of owned vertices.
struct SheetVelocities {
  std::vector<Vec3d> velocity;
  double span = 0;  ///< s, of the step at hand: friction stops nothing earlier
  double dt = 0;    ///< s, of the step that ends now; 0 at the start, when nothing is booked
};

/// Sheets::load to the weight; energy, outside, heatFlow to nothing.
void clearLoads(World& world);

/// Adds wind, wrap, brushes and the contact with obstacles: spring, dashpot and Coulomb friction within the
/// thickness of a surface.
void addOuterForces(World& world, const SheetVelocities& now);

/// Part of the difference of velocities that the air's drag may take away in a step: it acts by the velocity
/// of before the step.
inline constexpr double dragInAStep = 0.2;

/// 1/s, how fast the air takes vertices along, 2 rho |u_n| area / mass, the largest of this rank; with the
/// speed that they have when a step ends in which they are taken along by dragInAStep. Needs all loads.
double fastestDrag(const World& world, const SheetVelocities& now);

/// Adds the energy of the springs to the places of rest, as stiff as they are at this time (s).
void addRestEnergy(World& world, double time);

/// Momentum that springs to the places of rest, damping and clamps have given: before the step sign -1, after
/// it 1.
void bookHolding(World& world, double sign, double dt);

/// Half of the work of what pushes from outside over the step, by the forces of now: before vertices have
/// moved on to other ranks, and after the forces at the new places are known.
void bookOutsideWork(World& world);

}  // namespace thaw
