// How fine a run is.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// The spacings in effect and the quality, in one line, with the overrides ("key=value") that have changed
/// them; the same at a start and at a restart.
std::string resolutionLine(const Scene& scene, const std::vector<std::string>& overrides);

}  // namespace thaw
