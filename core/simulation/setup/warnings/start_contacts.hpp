// SPDX-License-Identifier: Apache-2.0
// Warnings about contacts of sheets before the first step.
#pragma once
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Pairs of a sheet and another object, by name, that already have a more severe warning.
using ReportedPairs = std::set<std::pair<std::string, std::string>>;

/// Appends a warning for each sheet that starts within contact distance of an obstacle, body, oriented body
/// or other sheet. `oriented`: positions of each oriented body's particles. The same on any number of ranks.
/// Collective.
void warnOfStartContacts(const World& world, const std::vector<std::vector<Vec3d>>& oriented,
                         const ReportedPairs& reported, Reducer& all, std::vector<SceneWarning>& warnings);

}  // namespace thaw
