// What looks unwise in [surface]: allowed, and told before the run.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// A line for each key whose value is far from all use: where it is, what it does there, what is sensible.
/// Empty without a surface.
std::vector<std::string> surfaceAdvice(const Scene& scene);

}  // namespace thaw
