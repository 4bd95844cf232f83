// SPDX-License-Identifier: Apache-2.0
// The parts of a scene's extensions and terms in a world (core/terms/extensions.hpp).
#pragma once
#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/simulation/time/step_limits.hpp"
#include "core/simulation/world/world.hpp"
#include "core/terms/term_work.hpp"

namespace thaw {

/// Starts the terms of the library that the scene uses. Adds unusable shapes to problems.
void startTerms(const Scene& scene, const Modules& modules, TermWork& terms, const MeshLoader& load,
                SceneProblems& problems);

/// Adds loads, pair forces, fields and their updates, and step limits of the scene's extensions. Also adds
/// pair forces of the library that the scene uses. Throws std::runtime_error for an unregistered extension,
/// and for a pair force that the scene excludes.
void addExtensions(World& world, TermWork& terms, StepLimits& limits);

}  // namespace thaw
