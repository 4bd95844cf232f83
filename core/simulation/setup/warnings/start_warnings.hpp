// SPDX-License-Identifier: Apache-2.0
// Warnings about probable mistakes with oriented bodies and sheets at the start of a scene.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Checks sampled bodies before the first step and returns warnings about
/// - sheets that are clamped as a whole, or far thicker than their vertex spacing;
/// - vertices and particles inside a liquid body (`shapes`: of Scene::bodies); inside a solid body they are
/// an error unless numerics.overlap is "keep";
/// - rows deep in contact with an obstacle, a sheet or an oriented body (`oriented`: positions of all their
/// particles);
/// - sheets within contact distance of anything (start_contacts.hpp).
/// Requires: walls at time 0. The same on any number of ranks. Collective.
std::vector<SceneWarning> bodyTypeStartWarnings(
    const World& world, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
    const std::vector<std::vector<Vec3d>>& oriented, Reducer& all, SceneProblems& problems);

}  // namespace thaw
