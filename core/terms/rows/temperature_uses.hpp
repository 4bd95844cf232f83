// SPDX-License-Identifier: Apache-2.0
// Use of heat in scenes in which temperature differences matter.
#pragma once
#include <vector>

#include "core/terms/model_part.hpp"

namespace thaw {

/// Returns a use of heat for each body and emitter whose temperature varies or differs from the others, for
/// terms that depend on temperature differences.
std::vector<ModuleUse> usesByTemperatures(const Scene& scene);

}  // namespace thaw
