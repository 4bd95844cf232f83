// Is what a checkpoint holds of the scene that goes on with it? Looked at whatever the marks say: from here
// on rows name places in lists of the scene.
#pragma once
#include <string>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

/// What of the rows of all ranks the scene has not, a line each, the same on all ranks; after restoreWorld,
/// with the modules and sheets of the scene. Collective.
std::vector<std::string> misfits(const World& world, Reducer& all);

}  // namespace thaw
