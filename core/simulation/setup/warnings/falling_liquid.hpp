// SPDX-License-Identifier: Apache-2.0
// Warnings about liquid that falls out of the domain.
#pragma once
#include <memory>
#include <vector>

#include "core/domain/emit.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Returns a warning for each body of liquid and each emitter whose particles all fall freely out of the
/// domain before the end. They leave through an open side. The warning contains the time of the fall. A fall
/// is free if no obstacle or solid body comes within a spacing of the path. It follows about 200 particles
/// per source, chosen by id. Scenes with sheets, oriented bodies or extensions give no warnings, since these
/// may stop or carry liquid. `shapes`: of Scene::bodies. particles: by body. Requires: sampled particles. The
/// same on any number of ranks. Collective.
std::vector<SceneWarning> fallingLiquids(const World& world,
                                         const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                                         const std::vector<EmitterPlan>& emitters,
                                         const std::vector<std::int64_t>& particles, Reducer& all);

}  // namespace thaw
