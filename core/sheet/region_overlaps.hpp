// Regions of a sheet that lie on each other: the later one's factors hold there, all of them.
#pragma once
#include "core/geometry/signed_distance.hpp"
#include "core/kinds/start_warnings.hpp"

namespace thaw {

/// A warning for each two regions of a sheet that share vertices, where the later one takes factors away that
/// the earlier one has. The same on all ranks.
std::vector<SceneWarning> overlapsOfRegions(const World& world, const MeshLoader& load);

}  // namespace thaw
