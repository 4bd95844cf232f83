// SPDX-License-Identifier: Apache-2.0
// Step limits of liquids with flow laws, for reports and warnings.
#pragma once
#include <string>
#include <vector>

#include "core/scene/modules.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/time/step_limits.hpp"

namespace thaw {

/// Returns a line for each liquid in use with a flow law: the law, the least rate, the largest viscosity and
/// its explicit step limit. Requires: prepareWorld.
std::vector<std::string> flowLawLines(const Scene& scene, const Modules& modules);

/// Returns a warning for each liquid with a flow law whose largest viscosity requires explicit steps below a
/// quarter of the sound limit. The implicit solver has no such limit. limits: of the materials.
std::vector<SceneWarning> thickFlows(const Scene& scene, const Modules& modules, const StepLimits& limits);

}  // namespace thaw
