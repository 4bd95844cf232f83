// SPDX-License-Identifier: Apache-2.0
// Surface tension of a material by its temperature.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Surface tension (N/m) of the liquid at a temperature (K): linear in its table, constant beyond the ends.
/// Without a table, Material::surfaceTension.
double surfaceTensionAt(const Material& material, double temperature);

/// Largest value (N/m) of a table of surface tensions; 0 if it is empty.
double largestTension(const TemperatureTable& table);

}  // namespace thaw
