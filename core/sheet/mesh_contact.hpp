// Contact of sheets with each other and with themselves: of vertices with triangles, and of edges with edges,
// so that nothing slides through between vertices.
#pragma once
#include "core/sheet/outer_forces.hpp"

namespace thaw {

/// Is there a sheet that touches itself, or more than one? `sheet`: does this one have a part in it?
bool meshesTouch(const Scene& scene);
bool meshTouches(const Scene& scene, std::size_t sheet);

/// How far (m) around a vertex all vertices lie that have a part in one of its contacts: cells must not be
/// smaller. 0 without such sheets.
double meshContactReach(const Scene& scene, const std::vector<SheetPlan>& plans);

/// Adds to Sheets::load, energy and resisting, to SheetBodies::slope and closing.
///
/// Of a vertex and a triangle, or two edges, whose nearest points are r < h apart, along n, the energy is
///   E = w m (k/2) (h - r)^2,  k = mass rate^2,  w = 1/(1 + c h^2/l^2),
/// where l is the mean length of edges, c 5 for a vertex and 16 for edges (together, where layers lie on each
/// other, about as stiff as one pair is to be), m 1 for a vertex, and sin^2 of the angle between two edges,
/// with which E goes smoothly to 0 as they become parallel and their nearest points indefinite. All pairs
/// within reach count, so that E has a slope everywhere: no nearest one is chosen. Dashpot and friction act
/// between the nearest points. The four vertices have the force by their shares of these points, which add up
/// to nothing: momentum is kept, and angular momentum too. h is the mean thickness, or, within a sheet, half
/// of the distance that the pair has at rest where that is less: what is joined at a vertex does not touch,
/// what lies beside each other does where it is pressed together to half. Each rank finds all pairs that one
/// of its vertices is in, and adds them ascending by the numbers of both in their meshes. Needs ghosts of
/// vertices with their ids.
void meetMeshes(World& world, const SheetVelocities& now);

}  // namespace thaw
