// SPDX-License-Identifier: Apache-2.0
// Contact of sheets with each other and with themselves, by vertex-triangle and edge-edge pairs. Sheets
// therefore cannot pass through each other between vertices.
#pragma once
#include "core/sheet/forces/outer_forces.hpp"

namespace thaw {

/// Returns the radius (m) around a vertex that contains all vertices of its contacts. It is the smallest
/// length of cells; 0 without such sheets.
double meshContactReach(const Scene& scene, const std::vector<SheetPlan>& plans);

/// Adds to Sheets::load, energy and dissipativeForce, and to SheetBodies::slope and closing.
///
/// A vertex and a triangle, or two edges, whose nearest points have a distance r < h along n, have the energy
///   E = w m (k/2) (h - r)^2,  k = mass rate^2,  w = 1/(1 + c h^2/l^2).
/// l is the mean edge length. c is 5 for a vertex and 16 for edges. Layers in contact are then about as stiff
/// as one pair. m is 1 for a vertex, and sin^2 of the angle between two edges. E thus vanishes smoothly as
/// they become parallel. All pairs within reach count, so E has a gradient everywhere. Dashpot and friction
/// act between the nearest points. The force is distributed to the four vertices by weights with sum 0, which
/// conserves linear and angular momentum. h is the mean thickness, but within one sheet at most half of the
/// pair's rest distance. Elements that share a vertex do not touch. Each rank finds all pairs with one of its
/// vertices, in ascending order. Requires: ghosts of vertices with ids.
void addMeshContact(SheetBodies& sheets, const Scene& scene, const SheetVelocities& now);

}  // namespace thaw
