// A surfel's own share of the surface.
#pragma once
#include "core/surface/bins.hpp"
#include "core/surface/surfels.hpp"

namespace thaw {

/// Who lies near whom, kept for volume keeping, which moves surfels a little and asks again. Not part of the state.
struct AreaLists {
  struct Candidate {
    double d2;  // m^2
    std::uint64_t id;
    std::uint32_t row;
    bool operator<(const Candidate& o) const { return d2 != o.d2 ? d2 < o.d2 : id < o.id; }
  };
  Bins bins;
  RowBlock block;
  std::vector<Vec3d> found;              // m, places of all rows then
  std::vector<std::uint64_t> first, end; // of owned rows
  std::vector<Candidate> near;
};

/// Surfels::area of all owned surfels: the area of the Voronoi cell among the neighbours of the same component (ghosts included), in the
/// tangent plane. Neighbours with normals within pi/4 are laid into it at the length of the arc between the two; those beyond (over an edge)
/// cut the cell where their own tangent plane does; those that look the other way (the far side of a sheet) are left out. Where neighbours
/// are missing the cell ends at the surfel's radius. again: the table is that of the last call, but for places. Not collective.
void findSurfelAreas(Surfels& surfels, AreaLists& lists, bool again = false);

}  // namespace thaw
