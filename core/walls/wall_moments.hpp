// SPDX-License-Identifier: Apache-2.0
// Moments of the neighbourhood and directions next to walls, which have no particles.
#pragma once
#include <span>

#include "core/math/mat3.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Returns the moment at all walls near a particle. If a second wall comes close at an angle to the nearest
/// one, the liquid between the walls cannot shear along either wall.
Sym3d alongAllWalls(const Sym3d& moment, std::span<const WallContact> contacts, double h);

/// Removes the components of a vector along the normals of adjacent walls.
Vec3d alongWalls(Vec3d v, std::span<const WallContact> contacts, double spacing);

}  // namespace thaw
