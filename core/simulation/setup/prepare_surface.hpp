// SPDX-License-Identifier: Apache-2.0
// Preparation of a scene's surface, before it has surfels.
#pragma once
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Sets radii and grid of world.surface from the scene. Throws std::runtime_error (one sentence) if a
/// periodic domain is too short.
void prepareSurface(World& world);

/// Activates the fields of a surface's tables that the modules need.
void activateSurfaceFields(Surface& surface, const Modules& modules, bool walls);

}  // namespace thaw
