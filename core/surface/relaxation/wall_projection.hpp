// SPDX-License-Identifier: Apache-2.0
// Projects surfels out of walls and obstacles (obstacle constraint, K05 4.2.3).
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/data/surface_view.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Returns a position (m) projected out of walls and obstacles. The surface then lies on the wall, on the
/// body's side. In a thin wall (the bottom of a glass), the nearest exit may be on the far side. outward:
/// outward normal of the body. The projection is repeated where walls meet.
Vec3d projectedOutOfWalls(const SurfaceView& view, const Vec3d& x, const Vec3d& outward);

/// Returns whether a position is inside a wall.
bool inWall(const SurfaceView& view, const Vec3d& x);

/// Returns whether a position (m) with this normal lies on a wall that the normal faces. Sets `into` to the
/// direction into the wall.
bool facesWall(const SurfaceView& view, const Vec3d& x, const Vec3d& normal, Vec3d& into);

/// Sets Surfels::wallAligned of owned surfels. It is set for surfels of `listed` that lie on a wall and face
/// it almost perpendicularly. Their normals are aligned with the wall. The iterations keep these surfels on
/// the wall while the body lies above. The colour's gradient is unreliable there, because it points sideways
/// below small drops. The column is inactive without walls.
void alignWithWalls(const SurfaceView& view, const std::vector<std::uint8_t>& listed);

/// Projects all owned surfels out of walls at the end of an update. A surfel that passed through a thin wall
/// returns to the side of the nearest particle of its component. Liquid surfels then lie on the wall, with
/// normals into the wall. Solid surfels are displaced from their position on the body (Surfels::wallOffset),
/// because the body keeps its shape while it penetrates the wall. Requires: placed surfels; bins of particle
/// copies and ghosts.
void projectOutOfWalls(const SurfaceView& view, const Bins& particleBins);

/// Projects surfels out again after volume enforcement has moved them. Updates Surfels::onWall.
void reprojectOutOfWalls(const SurfaceView& view);

/// Moves solid surfels back to their positions on the body.
void removeWallOffsets(Surfels& surfels);

}  // namespace thaw
