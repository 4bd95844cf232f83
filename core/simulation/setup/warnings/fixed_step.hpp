// SPDX-License-Identifier: Apache-2.0
// Warnings about fixed steps that are longer than the limits of the step.
#pragma once
#include <vector>

#include "core/scene/scene_warning.hpp"
#include "core/simulation/time/step_limits.hpp"

namespace thaw {

/// Returns a warning, with the names and values of the exceeded limits, if numerics.fixed_step is set and the
/// first step is longer than a limit. step: s, the first one. limits: of all ranks, at the start.
std::vector<SceneWarning> longFixedStep(const Scene& scene, double step, const StepLimits& limits);

}  // namespace thaw
