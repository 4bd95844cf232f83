// SPDX-License-Identifier: Apache-2.0
// The largest stable time step (docs/validation/stability.md B10; Monaghan 1992, Morris 1997), and its
// alignment with frame times.
#pragma once
#include "core/materials/liquid_materials.hpp"
#include "core/simulation/time/step_limits.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Returns the limits that depend on materials alone: sound, tension, elastic waves, contact, the scene's
/// own, and viscosity and heat of constant materials. It needs no particles, so it can be printed before a
/// run.
StepLimits materialLimits(const Scene& scene, const Modules& modules,
                          const std::vector<LiquidMaterial>& liquids);

LargestRates largestRates(const World& world);

/// Returns the limits of this rank's particles: acceleration, speed, and temperature-dependent viscosity,
/// stable on the lattice up to dt nu / h^2 = stableViscousStep. The caller reduces them over ranks.
StepLimits particleLimits(const World& world, const LargestRates& largest, double stableViscousStep);

/// Returns the largest ratio of the sound speed to that at rest in this rank's compressed liquid, at least 1;
/// it divides the sound limit of the materials. 1 with the linear equation of state.
double soundStiffening(const World& world);

/// Returns the acceleration limit (s) of a substep by the forces that act in substeps, for this rank's
/// particles. particleLimits excludes these forces.
double fastAccelerationLimit(const World& world);

/// frameTime: time (s) of a frame, equal to the end if they differ by rounding only. frameDue: true if the
/// next frame is due now.
double frameTime(const Clock& clock, std::int64_t frame);
bool frameDue(const Clock& clock);

/// Returns the longest step up to dt of which an integer number reaches exactly the next frame time or the
/// end. All steps are shortened slightly instead of the last one strongly: steps that vary periodically pump
/// energy into fast oscillations (docs/validation/stability.md, 10).
double clip(const Clock& clock, double dt);

/// Returns the next step (s), at most Clock::dt. It equals the last step where possible, so that limits that
/// vary by a percent or two, as with oscillating stretch, change no step. This costs two to four steps in a
/// hundred where limits do vary (scenes/melt.toml). A changed step is aligned with frame times. The result
/// depends on the clock alone, which is in every checkpoint.
double nextStep(const Clock& clock);

/// Returns the longest step (s) without any limit: from frame to frame, or to the end of a scene without
/// frames.
double longestUnlimitedStep(const Clock& clock);

/// Returns the time after a step of dt: exactly the frame time or the end if clip aligned the step.
double timeAfter(const Clock& clock, double dt);

}  // namespace thaw
