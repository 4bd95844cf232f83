// Surfels stay out of walls and obstacles (the obstacle constraint of K05 4.2.3).
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/bins.hpp"
#include "core/world.hpp"

namespace thaw {

/// Pushes a place out of walls and obstacles; the surface then lies on them, on the body's side: of thin ones
/// (the bottom of a glass) the nearest way out may be the far side, where the surface would enclose the wall.
/// `outward`: of the body there. Where walls meet it is pushed some times over.
Vec3d outOfWalls(const World& world, const Vec3d& x, const Vec3d& outward);

/// Is this place in a wall?
bool inWall(const World& world, const Vec3d& x);

/// Does what has this place and normal lie on a wall that it faces? `into`: that way.
bool facesWall(const World& world, const Vec3d& x, const Vec3d& normal, Vec3d& into);

/// Surfels::standing of owned ones: those of `listed` that lie on a wall and face it squarely; their normals
/// turn into it. The iterations leave them on it as long as there is body over the wall, whatever way the
/// colour falls off there: under a drop of a few particles that is to the side. Where there are no walls the
/// field is not active.
void findStanding(World& world, const std::vector<std::uint8_t>& listed);

/// The constraint at the end of an update, of all owned surfels, whatever has moved or borne them: none is in
/// a wall afterwards. One that has come through a thin wall, as seen from the nearest particle of its
/// component, goes back to that one's side. What is liquid lies on the wall from then on, with its normal
/// into it; what is solid is held off where its body would have it (Surfels::pressed), since it keeps its
/// shape: bodies dip into walls while these push them. Needs placed surfels, and bins of the particle copies
/// and their ghosts.
void keepOutOfWalls(World& world, const Bins& particleBins);

/// The same of surfels that volume keeping has moved: out again, nothing else. Finds Surfels::onWall anew.
void keepOutAgain(World& world);

/// Solids' surfels back to where their bodies have them.
void releasePressed(Surfels& surfels);

}  // namespace thaw
