// SPDX-License-Identifier: Apache-2.0
// Force on liquids due to the difference between their density and that at rest: -m f (theta - theta0) g. f
// is the liquid fraction, theta the relative density deficit, theta0 the neutralDeficit
// (core/scene/buoyancy.hpp).
#pragma once
#include "core/scene/scene.hpp"
#include "core/terms/outside_forces.hpp"

namespace thaw {

/// Sets Continuum::buoyancy from the temperatures, and adds the force to Continuum::force of liquid particles
/// that are free to move. Requires: Modules::buoyancy.
void addBuoyancy(const Scene& scene, Continuum& particles);

/// Records work and impulse of the buoyant force in a half kick over dt / 2 (s). Call it before the kick. The
/// force has no potential, since temperatures change. Its work is thus recorded like that of an external
/// force.
void recordBuoyantKick(const Continuum& particles, HalfKick kick, const Domain& domain, double dt,
                       Ledger& ledger);

}  // namespace thaw
