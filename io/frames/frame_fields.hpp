// SPDX-License-Identifier: Apache-2.0
// Fields of the frames of a scene.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/simulation/world/world.hpp"
#include "io/frames/frame.hpp"

namespace thaw {

/// Name in output.fields of the velocity of surfels, a field of the surface's frames.
inline constexpr const char* surfaceVelocityField = "surface_velocity";

/// Returns the names of fields of particles that output.fields may list.
std::vector<std::string> knownFrameFields();

/// Returns a frame with the scene's fields of the owned particles, and their ids. The state is in single
/// precision. Fields of a module that is off have constant values. The temperature is that of the body at the
/// start. Liquid is 0 or 1 by the material, the density is the rest density, and others are 0. The density of
/// solids is the rest density / det F, that of liquids the sum over neighbours. Liquids have 0 in stress,
/// strain and plastic_strain. Pressure, density and neighbours are those of the last step. Throws
/// std::invalid_argument for an unknown name. Requires: computeCauchyStress
/// (core/solid/elasticity/elastic.hpp) for `stress`; the world stays unchanged until the frame is written.
Frame frameOf(const World& world, int rank);

}  // namespace thaw
