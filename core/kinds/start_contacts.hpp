// What a sheet touches before the first step.
#pragma once
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/kinds/start_warnings.hpp"

namespace thaw {

/// Of a sheet and what it meets, by name: those that a graver warning tells of already.
using ToldPairs = std::set<std::pair<std::string, std::string>>;

/// A sentence for each pair of a sheet and an obstacle, body, oriented body or another sheet that begin
/// within the reach of their contact: they are pushed apart. `oriented`: the places of all particles of each
/// oriented body. The same on any number of ranks. Collective.
void warnOfStartContacts(const World& world, const std::vector<std::vector<Vec3d>>& oriented,
                         const ToldPairs& told, Reducer& all, std::vector<SceneWarning>& warnings);

}  // namespace thaw
