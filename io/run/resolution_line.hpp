// SPDX-License-Identifier: Apache-2.0
// The resolution of a run.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the spacings in effect and the quality in one line, with the overrides ("key=value") that set
/// them. It is the same at a start and at a restart.
std::string resolutionLine(const Scene& scene, const std::vector<std::string>& overrides);

}  // namespace thaw
