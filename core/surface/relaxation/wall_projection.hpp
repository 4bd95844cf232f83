// SPDX-License-Identifier: Apache-2.0
// Projects surfels out of walls and obstacles (obstacle constraint, K05 4.2.3).
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/data/surface_view.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Returns a position projected out of walls and obstacles. The surface then lies on them, on the body's
/// side. Through a thin wall (the bottom of a glass), the nearest exit may be the far side. `outward`:
/// outward normal of the body. Repeated where walls meet.
Vec3d projectedOutOfWalls(const SurfaceView& view, const Vec3d& x, const Vec3d& outward);

/// Returns whether a position is inside a wall.
bool inWall(const SurfaceView& view, const Vec3d& x);

/// Returns whether a position with this normal lies on a wall that it faces. `into`: direction into the wall.
bool facesWall(const SurfaceView& view, const Vec3d& x, const Vec3d& normal, Vec3d& into);

/// Finds Surfels::wallAligned of owned surfels: surfels of `listed` that lie on a wall and face it nearly
/// perpendicularly. Their normals are aligned with the wall. The iterations keep them on the wall while the
/// body lies above it. The colour's gradient is unreliable there: below small drops it points sideways.
/// Inactive without walls.
void alignWithWalls(const SurfaceView& view, const std::vector<std::uint8_t>& listed);

/// Projects all owned surfels out of walls at the end of an update. A surfel that passed through a thin wall,
/// as seen from the nearest particle of its component, returns to the particle's side. Liquid surfels then
/// lie on the wall, with normals into it. Solid surfels are displaced from their position on the body
/// (Surfels::wallOffset), because their shape is kept while penetrating. Requires: placed surfels; bins of
/// particle copies and ghosts.
void projectOutOfWalls(const SurfaceView& view, const Bins& particleBins);

/// Projects surfels out again after volume enforcement has moved them. Updates Surfels::onWall.
void reprojectOutOfWalls(const SurfaceView& view);

/// Moves solid surfels back to their positions on the body.
void removeWallOffsets(Surfels& surfels);

}  // namespace thaw
