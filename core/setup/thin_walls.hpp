// Solid bodies with walls that are too thin to hold liquid.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/kinds/start_warnings.hpp"
#include "core/world.hpp"

namespace thaw {

/// spacings, of a wall that holds liquid. A solid pushes a liquid with the liquid's own pressure, and one
/// layer of particles does not raise it: liquid passes.
constexpr double leastWall = 2;

/// A warning, with place and thickness, for each body that is solid at the start and has walls thinner than
/// `leastWall`, where something else is liquid or melts. At most some 20,000 particles of a body are looked
/// at, chosen by their ids. particles: of each body. The same on any number of ranks. Collective.
std::vector<SceneWarning> thinWalls(const World& world,
                                    const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                                    const std::vector<std::int64_t>& particles, Reducer& all);

}  // namespace thaw
