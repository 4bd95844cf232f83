// Forces among the vertices of a sheet: edges as springs, bending, the volume of a closed mesh (DS
// section 3.1).
#pragma once
#include "core/step.hpp"
#include "core/world.hpp"

namespace thaw {

/// Columns of Solids that edges need.
void activateEdges(SheetEdges& edges);

/// The table of vertices as bonds see it, now.
inline BondedRows vertexRows(Sheets& s) { return {s.owned, s.id.data(), s.slot.data(), s.body.data()}; }

/// As at the start: no ends and no bonds.
void emptyEdges(SheetBodies& sheets);

/// Before vertices migrate. At the start, and after a restart, no vertex has a slot yet. left: some vertex
/// has left the domain.
void forgetSlotsAtStart(SheetBodies& sheets, bool left);

/// The bonds that the plans say, of all slots of this rank: in the order of rings, then the vertices across
/// edges. Requests for Relink.
std::vector<BondRequest> edgeRequests(const SheetBodies& sheets);

/// Place in a slot's bonds of the neighbour with which bond k closes a triangle; -1 where there is none (or
/// it has left the domain). the same where some neighbour has left
int searchTriangle(const Bonds& bonds, std::size_t slot, double next);
inline int triangleWith(const Bonds& b, std::size_t slot, int k) {
  const double next = b.z[b.at(slot, k)];
  if (!(next > 0)) return -1;
  const int guess = static_cast<int>(next) - 1;
  return guess < b.capacity && b.weight[b.at(slot, guess)] == next ? guess : searchTriangle(b, slot, next);
}

/// Vectors from a slot's vertex to the other ends: Solids::position has to be up to date on both.
inline Vec3d edgeVector(const SheetEdges& e, std::size_t slot, int k) {
  return e.ends.position[e.bonds.neighbour[e.bonds.at(slot, k)]] - e.ends.position[slot];
}

/// Positions of vertices to the ends of edges, remote ones too. Collective.
void sendEnds(SheetBodies& sheets, BondHalo& edges);

/// Area vector of a slot's vertex, m^2: of a third of its triangles. Of a closed sheet also the gradient of
/// its volume.
Vec3d facingOf(const SheetEdges& e, std::size_t slot);

/// Adds to Sheets::load and energy, writes Sheets::facing; SheetPart::now where volume matters;
/// SheetBodies::slope. Collective.
void addInnerForces(World& world, Halos halos);

}  // namespace thaw
