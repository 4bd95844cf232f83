// SPDX-License-Identifier: Apache-2.0
// Heat of scenes in which differences of temperature matter.
#pragma once
#include <vector>

#include "core/terms/model_part.hpp"

namespace thaw {

/// Returns a use of heat for each body and emitter whose temperature differs from others, or within it. For
/// terms to which such differences matter.
std::vector<ModuleUse> usesByTemperatures(const Scene& scene);

}  // namespace thaw
