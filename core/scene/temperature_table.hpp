// SPDX-License-Identifier: Apache-2.0
// Interpolation in tables by temperature.
#pragma once
#include "core/scene/flow_law.hpp"

namespace thaw {

enum class Interpolation { Linear, Logarithmic };

/// Returns the value of a table at temperature T (K), constant beyond its ends.
/// Requires: the table is not empty.
double valueAt(const TemperatureTable& table, double T, Interpolation between);

}  // namespace thaw
