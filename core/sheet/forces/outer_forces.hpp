// SPDX-License-Identifier: Apache-2.0
// External forces on a sheet: weight, wind, shrink-wrap, pressure brushes, obstacles (DS section 3.1). Also
// the ledger entries of constraints.
#pragma once
#include "core/sheet/data/sheet_view.hpp"

namespace thaw {

/// Velocities (m/s) of owned vertices at the time of the forces.
struct SheetVelocities {
  std::vector<Vec3d> velocity;
  double span = 0;  ///< s, current step: friction takes at least this time to stop a motion
  double dt = 0;    ///< s, step that ends now; 0 at the start, where nothing is recorded
};

/// Sets Sheets::load to the weight, and energy, outside and heatFlow to 0.
void clearLoads(SheetBodies& sheets, const Scene& scene);

/// Adds wind, shrink-wrap, pressure brushes and obstacle contact: spring, dashpot and Coulomb friction within
/// the thickness of a surface.
void addOuterForces(const SheetView& view, const SheetVelocities& now);

/// Largest fraction of the relative velocity that air drag removes in a step, since drag uses the velocity
/// before the step.
inline constexpr double dragInAStep = 0.2;

/// Returns the largest drag rate (1/s) on this rank, 2 rho |u_n| area / mass. u_n is the speed at the end of
/// a step limited by dragInAStep. Requires: all loads.
double fastestDrag(const SheetBodies& sheets, const Scene& scene, const SheetVelocities& now);

/// Adds the energy of the springs to rest positions, with the stiffness at this time (s).
void addRestEnergy(SheetBodies& sheets, const Scene& scene, double time);

/// Records the impulse of rest springs, damping and clamps. Call with sign -1 before the step of dt (s) and 1
/// after it.
void recordConstraintImpulse(const SheetBodies& sheets, Ledger& ledger, double sign, double dt);

/// Records half of the external work of a step with the current forces. Call it twice: before vertices
/// migrate, and when the forces at the new positions are known.
void recordExternalWork(const SheetBodies& sheets, Ledger& ledger);

}  // namespace thaw
