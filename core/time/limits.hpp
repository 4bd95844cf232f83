// The largest stable time step (docs/validation/stability.md B10; Monaghan 1992, Morris 1997), and the clock
// that lands on frame times.
#pragma once
#include <array>

#include "core/fluid/liquid_materials.hpp"
#include "core/world.hpp"

namespace thaw {

enum class Limit {
  Sound,
  Viscous,
  Heat,
  Elastic,
  Tension,
  Acceleration,
  Speed,
  Contact,
  Scene,
  Oriented,
  Sheet
};
inline constexpr std::array<const char*, 11> limitNames{
    "sound", "viscosity", "heat",  "elastic waves",      "surface tension", "acceleration",
    "speed", "contact",   "scene", "oriented particles", "sheets"};
inline constexpr std::size_t kindLimits = 2;  ///< the last ones: of the further kinds, reduced only where a
                                              ///< scene has one

inline constexpr double supportsPerStep = 0.25;  ///< nobody passes through a particle, or a cell, in a step

/// Limits in s; `never` where one does not apply.
struct StepLimits {
  std::array<double, limitNames.size()> value;
  StepLimits() { value.fill(never); }
  double& operator[](Limit l) { return value[static_cast<std::size_t>(l)]; }
  Limit smallest() const;
};

/// Limits of materials alone: sound, tension, elastic waves, contact, the scene's own; and viscosity and heat
/// of materials that do not change. Without particles, so that it can be printed before a run.
StepLimits materialLimits(const Scene& scene, const Modules& modules,
                          const std::vector<LiquidMaterial>& liquids);

/// What limits the step of a rank's particles by their motion.
struct LargestRates {
  double speed2 = 0;         ///< m^2/s^2, square of the largest speed
  double acceleration2 = 0;  ///< m^2/s^4, of the largest acceleration; without forces that substeps kick with
};
LargestRates largestRates(const World& world);

/// The limits of this rank's particles: acceleration, speed, and viscosity that depends on temperature,
/// stable on the lattice up to dt nu / h^2 = stableViscousStep. To be reduced over ranks.
StepLimits particleLimits(const World& world, const LargestRates& largest, double stableViscousStep);

/// How many times faster than at rest sound is where this rank's liquid is compressed most, at least 1: the
/// limit of sound is that of the materials divided by it. 1 with the linear equation of state.
double soundStiffening(const World& world);

/// The limit (s) of acceleration by the forces that substeps kick with, of this rank's particles: of a
/// substep. particleLimits leaves these forces out.
double fastAccelerationLimit(const World& world);

/// Time (s) of a frame; the one that rounding puts just beside the end is the end. frameDue: the next one is
/// to be written now.
double frameTime(const Clock& clock, std::int64_t frame);
bool frameDue(const Clock& clock);

/// The longest step up to dt of which a whole number leads exactly to the next frame time or the end. All of
/// them are cut a little rather than the last ones much: a step that changes from frame to frame in the same
/// way pumps energy into what swings fast (docs/validation/stability.md, 10).
double clip(const Clock& clock, double dt);

/// The length (s) of the next step, at most Clock::dt. As long as it can be, it is that of the last step: a
/// limit that wavers by a percent or two, as the stretch of what swings does, changes no step. That costs two
/// to four steps in a hundred where limits do waver (scenes/melt.toml). Where it is to change, it is cut so
/// that frame times are hit. A function of the clock alone, which is in every checkpoint.
double nextStep(const Clock& clock);

/// The longest step (s) where no term limits it: from frame to frame, or to the end of a scene without
/// frames.
double longestUnlimitedStep(const Clock& clock);

/// Time after a step of dt: exactly the frame time or the end where clip had cut.
double timeAfter(const Clock& clock, double dt);

}  // namespace thaw
