// The matrix of the pressure problem, by its products: what pressures do to velocities, and velocities to the
// filling.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// What a pass over the system needs.
struct PressureSystem {
  World& world;
  Halos halos;
  StepTools& tools;
};

/// PressureWork::walls, fraction and response, of the places as they are.
void prepareSystem(const PressureSystem& system);

/// PressureWork::impulse (N s) of Continuum::trialPressure, and trialVelocity = start + impulse / m (held and
/// driven ones keep theirs). Collective.
void applyPressures(const PressureSystem& system);

/// PressureWork::rate (1/s) of the filling with trialVelocity. Collective.
void rateOfFilling(const PressureSystem& system);

}  // namespace thaw
