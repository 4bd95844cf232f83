// One update of the surface (K05 section 4): the page to read.
#pragma once
#include "core/geometry/triangle_mesh.hpp"
#include "core/halo/surface_halos.hpp"
#include "core/neighbours/sort.hpp"
#include "core/surface/open_region.hpp"
#include "core/surface/relax_tools.hpp"
#include "core/surface/row_lists.hpp"
#include "core/surface/start_pieces.hpp"
#include "core/surface/surface_times.hpp"
#include "core/surface/update_components.hpp"
#include "core/world.hpp"

namespace thaw {

/// What an update works with; made once, reused. Nothing of it is part of the state.
struct SurfaceTools {
  SortBuffers sort;
  MeshLoader load;        ///< of the bodies' meshes; set before startSurface
  RowLists surfelsOf;     ///< surfels around the owned ones that resampling looks at
  OpenRegion openRegion;  ///< where its later rounds look
  TopologyTools topology;
  RelaxTools relax;                  ///< of displacement and iterations
  std::vector<std::uint64_t> lumps;  ///< labels, ascending: of liquids that startSurface has grown as one
                                     ///< lump though they have sheets near each other
  std::vector<BodyPieces> pieces;    ///< of bodies that are several pieces at the start, though no layer is
                                     ///< missing between them
  SurfaceTimes times;                ///< of all updates of this process; the start is not in them
};

/// The first surface, of the bodies at their start. Needs Surface without surfels and particles in place.
/// Collective.
void startSurface(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Carries the surfels along with the particles and lets them settle on them; splits and merges components.
/// The same bits on any number of ranks. Collective.
void updateSurface(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
