// Solid bodies with walls that are too thin to hold liquid.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/kinds/start_warnings.hpp"
#include "core/world.hpp"

namespace thaw {

/// A solid pushes a liquid with the liquid's own pressure, which a single layer does not raise: liquid passes it.
constexpr double leastWall = 2;  ///< spacings, of a wall that holds liquid

/// A warning for each body that is solid at the start and has walls thinner than `leastWall`, in a scene where something else is
/// liquid or melts, with the place and the thickness there. At most some 20,000 particles of a body are looked at, chosen by
/// their ids. particles: of each body. Same on any number of ranks. Collective.
std::vector<SceneWarning> thinWalls(const World& world, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                                    const std::vector<std::int64_t>& particles, Reducer& all);

}  // namespace thaw
