// SPDX-License-Identifier: Apache-2.0
// Types of limits of the time step.
#pragma once
#include <array>
#include <cstddef>

#include "core/scene/scene.hpp"

namespace thaw {

enum class Limit {
  Sound,
  Density,
  Viscous,
  Heat,
  Elastic,
  Tension,
  Acceleration,
  Speed,
  Contact,
  Scene,
  Extension,
  Oriented,
  Sheet
};
inline constexpr std::array<const char*, 13> limitNames{
    "sound",           "density change",     "viscosity", "heat",    "elastic waves",
    "surface tension", "acceleration",       "speed",     "contact", "scene",
    "extensions",      "oriented particles", "sheets"};
inline constexpr std::size_t bodyTypeLimits = 2;  ///< the last entries are for body types other than the
                                                  ///< continuum, and are reduced only in scenes that have
                                                  ///< them

/// Largest change of a carried relative density in a step.
inline constexpr double densityChangePerStep = 0.02;
inline constexpr double supportsPerStep = 0.25;  ///< maximum motion in a step, so that no particle crosses
                                                 ///< another particle or a cell

/// Limits in s; `never` if not applicable.
struct StepLimits {
  std::array<double, limitNames.size()> value;
  StepLimits() { value.fill(never); }
  double& operator[](Limit l) { return value[static_cast<std::size_t>(l)]; }
  double operator[](Limit l) const { return value[static_cast<std::size_t>(l)]; }
  Limit smallest() const;
};

/// Largest rates of motion of a rank's particles.
struct LargestRates {
  double speed2 = 0;         ///< m^2/s^2, square of the largest speed
  double acceleration2 = 0;  ///< m^2/s^4, square of the largest acceleration, without forces that act in
                             ///< substeps
};

}  // namespace thaw
