// SPDX-License-Identifier: Apache-2.0
// The modules of a scene, with the reasons for them.
#pragma once
#include "core/scene/modules.hpp"

namespace thaw {

/// Returns the modules that the scene needs.
Modules modulesOf(const Scene& scene);

}  // namespace thaw
