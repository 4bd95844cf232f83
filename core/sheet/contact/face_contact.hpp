// SPDX-License-Identifier: Apache-2.0
// Contact of continuum particles with triangles, for sheets that are about as coarse as the particles, or
// coarser. A particle's depth combines all triangles within reach (face_depth.hpp). Finer sheets use pairs of
// vertex and particle (sheet_contact.hpp).
#pragma once
#include <array>

#include "core/halo/halos.hpp"
#include "core/sheet/forces/outer_forces.hpp"

namespace thaw {

/// Returns whether particles could pass between the vertices, or push them apart.
bool coarserThanParticles(const Scene& scene, const SheetPlan& plan);

/// Returns the radius (m) around a particle that contains all corners of triangles in contact with it. It is
/// the smallest length of cells; 0 without such sheets.
double faceContactReach(const std::vector<SheetPlan>& plans);

/// Adds to load, energy, dissipativeForce, heatFlow and slope of sheets, and to force, interaction,
/// dissipation and heatFlow of particles. A particle's owner computes depth and force from triangles
/// with all corners in the 27 cells around the particle and around each other. The corners' owners also find
/// these triangles. They add their fractions in (cell, id) order of the particles. Friction acts only at the
/// nearest point, since it stores no energy. Requires: ghosts of vertices with ids, and of particles.
/// Collective.
void addFaceContact(const SheetView& view, Halos halos, const SheetVelocities& now);

}  // namespace thaw
