// SPDX-License-Identifier: Apache-2.0
// The keys of [numerics] that a scene sets.
#pragma once
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns whether a key of [numerics] ("numerics.cfl_elastic") differs from its default. False for keys that
/// the restart record omits.
bool isChosen(const std::string& key, const Numerics& numerics);

}  // namespace thaw
