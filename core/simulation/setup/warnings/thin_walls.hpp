// SPDX-License-Identifier: Apache-2.0
// Warnings about solid bodies with walls too thin to hold liquid.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Minimum thickness, in spacings, of a wall that retains liquid. A solid responds with the liquid's own
/// pressure. A single layer of particles does not raise this pressure, so liquid passes through.
constexpr double leastWall = 2;

/// Returns a warning for each initially solid body with walls thinner than `leastWall`, if something else is
/// liquid or melts. The warning contains a position and the thickness. It checks at most about 20,000
/// particles per body, chosen by id. particles: by body. The same on any number of ranks. Collective.
std::vector<SceneWarning> thinWalls(const World& world,
                                    const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                                    const std::vector<std::int64_t>& particles, Reducer& all);

}  // namespace thaw
