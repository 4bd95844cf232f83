// SPDX-License-Identifier: Apache-2.0
// Warnings about heated regions without particles at the start.
#pragma once
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/scene_warning.hpp"

namespace thaw {

/// Returns a warning for each heated region that does not move and contains no particle that it heats. Scenes
/// with emitters give no warnings, since emitted particles may reach the region. The same on any number of
/// ranks. Requires: the particles of the start. Collective.
std::vector<SceneWarning> emptyRegions(const Scene& scene, const Continuum& particles, const MeshLoader& load,
                                       Reducer& all);

}  // namespace thaw
