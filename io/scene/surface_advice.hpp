// SPDX-License-Identifier: Apache-2.0
// Warnings of unusual settings of [surface], before the run.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns a line for each unusual value: its place, its effect, and the recommended range. Returns nothing
/// without a surface.
std::vector<std::string> surfaceAdvice(const Scene& scene);

}  // namespace thaw
