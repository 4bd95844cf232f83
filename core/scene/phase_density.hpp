// SPDX-License-Identifier: Apache-2.0
// Densities at rest (kg/m^3) of materials whose phases differ in density.
#pragma once
#include <algorithm>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns true if the solid and the liquid of a material differ in density.
inline bool hasPhaseDensities(const Material& m) { return m.solidDensity > 0 && m.solidDensity != m.density; }

/// Returns the density (kg/m^3) of the solid at rest.
inline double solidDensityOf(const Material& m) { return m.solidDensity > 0 ? m.solidDensity : m.density; }

/// Returns the smaller density (kg/m^3) of the two phases. It gives a step limit for particles of either
/// phase.
inline double leastDensityOf(const Material& m) { return std::min(m.density, solidDensityOf(m)); }

}  // namespace thaw
