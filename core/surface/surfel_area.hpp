// A surfel's own share of the surface.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/bins.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_kernels.hpp"

namespace thaw {

/// Who lies near whom, kept for volume keeping, which moves surfels a little and asks again. Not part of the
/// state.
struct AreaLists {
  const SurfaceKernels* kernels = surfaceKernels();
  Bins bins;
  RowBlock block;
  std::vector<Vec3d> found;           // m, places of all rows then
  std::vector<std::uint32_t> asking;  // owned rows in the order of the bins
  std::vector<std::uint64_t> first;  // near[first[k]] ... near[first[k + 1] - 1] are around asking[k], in the
                                     // order of the bins
  std::vector<std::uint32_t> near;
  AlignedVector<double> place, normal;  // records of the kernel
};

/// No areas, no volume.
void clearAreas(Surfels& surfels);

/// Surfels::area, facets, bulge and rim of all owned surfels: the area of the Voronoi cell among the
/// neighbours of the same component (ghosts included), in the tangent plane. Neighbours with normals within
/// pi/4 are laid into it at the length of the arc between the two; those beyond (over an edge) cut the cell
/// where their own tangent plane does; those that look the other way (the far side of a sheet) are left out.
/// Where neighbours are missing the cell ends at the surfel's radius. Facets are those between it and the
/// neighbours that its cell borders on. Needs ghosts. again: the table is that of the last call, but for
/// places. Collective.
void findSurfelAreas(Surface& surface, Reducer& all, AreaLists& lists, bool again = false);

}  // namespace thaw
