// Contact of particles of the continuum with the triangles of a sheet whose vertices are about as far apart
// as the particles or further: each particle by its depth in all that are within reach (face_depth.hpp).
// Pairs of vertex and particle (sheet_contact.hpp) do for finer sheets, whose vertices would slip through
// between particles otherwise.
#pragma once
#include <array>

#include "core/sheet/outer_forces.hpp"

namespace thaw {

/// Could particles pass between its vertices, or press them apart?
bool coarserThanParticles(const Scene& scene, const SheetPlan& plan);

/// How far (m) around a particle all corners of a triangle that it touches lie: cells must not be smaller. 0
/// without such sheets.
double faceContactReach(const std::vector<SheetPlan>& plans);

/// Adds to Sheets::load, energy, resisting, heatFlow, slope, and to force, interaction, dissipation and
/// heatFlow of particles. The owner of a particle finds its depth in the triangles, of those whose corners
/// and it all lie in each other's 27 cells, and the force; the owners of the corners find the triangles again
/// and take their shares in the order (cell, id) of the particles. Friction is that of the nearest point
/// alone: it stores nothing. Needs ghosts of vertices with their ids, and of particles. Collective.
void meetFaces(World& world, Halos halos, const SheetVelocities& now);

}  // namespace thaw
