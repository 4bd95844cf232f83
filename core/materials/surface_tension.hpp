// SPDX-License-Identifier: Apache-2.0
// Surface tension of a material as a function of temperature.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Surface tension (N/m) of the liquid at a temperature (K). A table is interpolated linearly and is constant
/// beyond its ends. Without a table, the result is Material::surfaceTension.
double surfaceTensionAt(const Material& material, double temperature);

/// Largest value (N/m) of a table of surface tensions; 0 if it is empty.
double largestTension(const TemperatureTable& table);

/// Returns the time scale (s) of the step limit of tension, sqrt(rho h^3 / (2 pi gamma)). Here rho is the
/// smaller density of the two phases. Requires: surfaceTension > 0.
double capillaryTime(const Scene& scene, const Material& material);

}  // namespace thaw
