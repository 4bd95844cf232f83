// Liquid that starts compressed, and bursts.
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/kinds/start_warnings.hpp"
#include "core/world.hpp"

namespace thaw {

struct StepTools;

/// A warning for each body whose liquid holds so much energy of compression at time 0 that it would fly apart
/// at more than a tenth of the largest speed that the scene makes: its lattice, of whole spacings, is wider
/// than the space that walls and other bodies leave. After the first evaluation. The same on any number of
/// ranks. Collective.
std::vector<SceneWarning> pressedLiquids(const World& world, const StepTools& tools, Reducer& all);

}  // namespace thaw
