// SPDX-License-Identifier: Apache-2.0
// Internal forces of a sheet: edge springs, bending, and the volume of a closed mesh (DS section 3.1).
#pragma once
#include "core/halo/halos.hpp"
#include "core/sheet/data/sheets.hpp"

namespace thaw {

/// Activates the columns of Solids that edges need.
void activateEdges(SheetEdges& edges);

/// Returns the vertices as endpoints of bonds.
inline BondedRows vertexRows(Sheets& s) { return {s.owned, s.id.data(), s.solidIndex.data(), s.body.data()}; }

/// Removes all ends and bonds, as at the start.
void clearEdges(SheetBodies& sheets);

/// Clears solid indices before vertices migrate, if no indices are assigned yet: at the start and after a
/// restart. left: true if any vertex has left the domain.
void clearSolidsAtStart(SheetBodies& sheets, bool left);

/// Returns the bonds of the plans for all vertices of this rank: rings in order, then the vertices across
/// edges.
std::vector<BondRequest> edgeRequests(const SheetBodies& sheets);

/// Returns the bond index of the neighbour that closes a triangle with bond k of a vertex, or -1 without a
/// triangle. searchTriangle does the same if a neighbour has left the domain.
int searchTriangle(const Bonds& bonds, std::size_t solidIndex, double next);
inline int triangleWith(const Bonds& b, std::size_t solidIndex, int k) {
  const double next = b.z[b.at(solidIndex, k)];
  if (!(next > 0)) return -1;
  const int guess = static_cast<int>(next) - 1;
  return guess < b.capacity && b.weight[b.at(solidIndex, guess)] == next
             ? guess
             : searchTriangle(b, solidIndex, next);
}

/// Returns the vector from a vertex to the other end. Requires: current Solids::position at both.
inline Vec3d edgeVector(const SheetEdges& e, std::size_t solidIndex, int k) {
  return e.ends.position[e.bonds.neighbour[e.bonds.at(solidIndex, k)]] - e.ends.position[solidIndex];
}

/// Copies positions of vertices to the ends of edges, including remote ends. Collective.
void updateEdgeEnds(SheetBodies& sheets, BondHalo& edges);

/// Returns the area vector (m^2) of a vertex, a third of its triangles' area vectors. For a closed sheet, it
/// is the gradient of the volume.
Vec3d areaNormalOf(const SheetEdges& e, std::size_t solidIndex);

/// Adds to Sheets::load and energy, and to SheetBodies::slope. Sets Sheets::areaNormal, and SheetPart::now
/// for parts with volume stiffness. Collective.
void addInnerForces(SheetBodies& sheets, const Scene& scene, Halos halos);

}  // namespace thaw
