// SPDX-License-Identifier: Apache-2.0
// Converts lamps and lasers of a scene to the light of one step.
#pragma once
#include <cstdint>
#include <vector>

#include "core/heat/sources/light_view.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the light of the step [begin, end] (s). An area lamp shines from one of 16 points, selected in
/// turn by the step number.
std::vector<LightSource> lightSources(const Scene& scene, double begin, double end, std::int64_t step);

/// Returns the power (W) of a source. For a lamp with a direction, it is the light that enters the domain.
double givenPower(const LightSource& source, const Domain& domain);

}  // namespace thaw
