// SPDX-License-Identifier: Apache-2.0
// Area of the surface that belongs to each surfel.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/kernels/surface_kernels.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Neighbour lists, kept while volume enforcement moves surfels slightly. Not part of the state.
struct AreaLists {
  const SurfaceKernels* kernels = surfaceKernels();
  Bins bins;
  RowBlock block;
  std::vector<Vec3d> found;            // m, positions of all rows at the search
  std::vector<std::uint32_t> queries;  // owned rows in the order of the bins
  // near[first[k]] ... near[first[k + 1] - 1] are neighbours of asking[k], in the order of the bins
  std::vector<std::uint64_t> first;
  std::vector<std::uint32_t> near;
  AlignedVector<double> place, normal;  // packed data of the kernel
};

/// Sets areas and volumes to zero.
void clearAreas(Surfels& surfels);

/// Computes Surfels::area, facets, bulge and rim of all owned surfels. The area is that of the Voronoi cell
/// in the tangent plane, among neighbours of the same component (ghosts included). Neighbours with normals
/// within 60 degrees are mapped into the plane at their arc length. Neighbours across an edge clip the cell
/// at their own tangent plane. Neighbours with opposite normals (the back of a sheet) are ignored. Without
/// neighbours, the cell ends at the surfel's radius. Facets connect the surfel with the neighbours at its
/// cell's borders. Requires: ghosts. again: only positions have changed since the last call. Collective.
void findSurfelAreas(Surface& surface, Reducer& all, AreaLists& lists, bool again = false);

}  // namespace thaw
