// SPDX-License-Identifier: Apache-2.0
// The matrix of the pressure problem as products: from pressures to velocities, and from velocities to
// density rates.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Context of the products.
struct PressureSystem {
  World& world;
  Halos halos;
  StepTools& tools;
};

/// Computes PressureWork::walls, fraction and response for the current positions.
void prepareSystem(const PressureSystem& system);

/// Computes PressureWork::impulse (N s) from Continuum::trialPressure, and trialVelocity = start + impulse /
/// m; clamped and driven particles keep theirs. Collective.
void applyPressures(const PressureSystem& system);

/// Computes PressureWork::rate (1/s) of the relative density for trialVelocity. Collective.
void relativeDensityRate(const PressureSystem& system);

}  // namespace thaw
