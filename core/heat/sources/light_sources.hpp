// SPDX-License-Identifier: Apache-2.0
// Lamps and lasers of a scene as light of one step.
#pragma once
#include <cstdint>
#include <vector>

#include "core/heat/sources/light_view.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the light of the step [begin, end] (s). An area lamp shines from one of 16 points, in turn by the
/// number of the step.
std::vector<LightSource> lightSources(const Scene& scene, double begin, double end, std::int64_t step);

/// Power (W) of lamps, or of lasers. That of a lamp with a direction is the light that enters the domain.
double givenPower(const LightSource& source, const Domain& domain);

}  // namespace thaw
