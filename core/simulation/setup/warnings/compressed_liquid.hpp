// SPDX-License-Identifier: Apache-2.0
// Warnings about liquid that starts compressed and would burst.
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Returns a warning for each body of liquid that would burst at more than a tenth of the largest expected
/// speed. The speed follows from the compression energy at time 0. The body's lattice of whole spacings is
/// then wider than the space between walls and other bodies. Call it after the first evaluation. The same on
/// any number of ranks. Collective.
std::vector<SceneWarning> compressedLiquids(const World& world, const std::vector<LiquidMaterial>& liquids,
                                            Reducer& all);

}  // namespace thaw
