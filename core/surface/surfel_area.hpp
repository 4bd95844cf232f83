// A surfel's own share of the surface.
#pragma once
#include "core/surface/point_bins.hpp"
#include "core/surface/surfels.hpp"

namespace thaw {

/// Surfels::area of all owned surfels: the area of the Voronoi cell among the neighbours of the same component (ghosts included), in the
/// tangent plane. Neighbours with normals within pi/4 are laid into it at the length of the arc between the two; those beyond (over an edge)
/// cut the cell where their own tangent plane does; those that look the other way (the far side of a sheet) are left out. Where neighbours
/// are missing the cell ends at the surfel's radius. `bins` are made anew. Not collective.
void findSurfelAreas(Surfels& surfels, PointBins& bins);

}  // namespace thaw
