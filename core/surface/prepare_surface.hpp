// From a scene to a surface without surfels.
#pragma once
#include "core/world.hpp"

namespace thaw {

/// Radii and grid of world.surface, from the scene. Throws std::runtime_error (one sentence) for a periodic
/// domain that is too short.
void prepareSurface(World& world);

/// Switches on what the modules need of a surface's tables.
void activateSurfaceFields(Surface& surface, const Modules& modules, bool walls);

}  // namespace thaw
