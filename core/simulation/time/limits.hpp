// SPDX-License-Identifier: Apache-2.0
// The largest stable time step (docs/validation/stability.md, row 10; M92, MFZ97).
#pragma once
#include <array>

#include "core/materials/liquid_materials.hpp"
#include "core/simulation/time/step_limits.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Returns the limits that depend on materials alone: sound, tension, elastic waves, contact, the scene's own
/// limit, and viscosity and heat of constant materials. They need no particles, so they can be printed before
/// a run.
StepLimits materialLimits(const Scene& scene, const Modules& modules,
                          const std::vector<LiquidMaterial>& liquids);

/// Explicit step limit (s) for the largest viscosity that the flow law of a material reaches. It is reached
/// at rest, or for n > 1 at the largest rate that the scene resolves.
double flowLawStepLimit(const Scene& scene, const Material& material);

/// Limits that apply only while there is liquid.
inline constexpr std::array limitsOfLiquid{Limit::Sound, Limit::Viscous, Limit::Tension};
/// Returns true if limitsOfLiquid may not apply for a while, since all solids have substeps and liquid arises
/// only by melting.
bool mayBeDry(const Scene& scene, const Modules& modules);
/// Returns true if no owned particle is even partly liquid.
bool isDry(const Continuum& particles);

LargestRates largestRates(const Continuum& particles);

/// Returns the limits of this rank's particles: acceleration, speed, and viscosity of tables and flow laws.
/// Viscous steps are stable on the lattice up to dt nu / h^2 = stableViscousStep. The caller reduces the
/// limits over ranks.
StepLimits particleLimits(const World& world, const LargestRates& largest, double stableViscousStep);

/// Returns the largest ratio of the sound speed to that at rest in this rank's compressed liquid, at least 1.
/// The sound limit of the materials is divided by it. With the linear equation of state it is 1.
double soundStiffening(const Scene& scene, const Modules& modules, const Continuum& particles);

/// Returns the limit (s) of a substep by the accelerations due to forces that act in substeps, for this
/// rank's particles. particleLimits excludes these forces.
double fastAccelerationLimit(const Scene& scene, const CellGrid& grid, const Continuum& particles);

}  // namespace thaw
