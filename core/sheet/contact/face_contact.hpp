// SPDX-License-Identifier: Apache-2.0
// Contact of continuum particles with triangles, for sheets whose vertices are as far apart as particles or
// farther. A particle's depth combines all triangles within reach (face_depth.hpp). Finer sheets use pairs of
// vertex and particle (sheet_contact.hpp).
#pragma once
#include <array>

#include "core/halo/halos.hpp"
#include "core/sheet/forces/outer_forces.hpp"

namespace thaw {

/// Returns whether particles could pass between the vertices, or press them apart.
bool coarserThanParticles(const Scene& scene, const SheetPlan& plan);

/// Returns the radius (m) around a particle that contains all corners of triangles in contact with it: the
/// least length of cells. 0 without such sheets.
double faceContactReach(const std::vector<SheetPlan>& plans);

/// Adds to Sheets::load, energy, dissipativeForce, heatFlow, slope, and to force, interaction, dissipation
/// and heatFlow of particles. A particle's owner computes its depth and force from the triangles whose
/// corners lie in the 27 cells around it and around each other. The corners' owners find the triangles again
/// and add their fractions in (cell, id) order of the particles. Friction acts at the nearest point only,
/// since it stores no energy. Requires: ghosts of vertices with ids, and of particles. Collective.
void addFaceContact(const SheetView& view, Halos halos, const SheetVelocities& now);

}  // namespace thaw
