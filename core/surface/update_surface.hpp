// SPDX-License-Identifier: Apache-2.0
// Update of the surface (K05 section 4): overview.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/halo/surface_halos.hpp"
#include "core/neighbours/sort.hpp"
#include "core/simulation/world/world.hpp"
#include "core/surface/data/surface_times.hpp"
#include "core/surface/relaxation/relax_tools.hpp"
#include "core/surface/resampling/active_set.hpp"
#include "core/surface/search/row_lists.hpp"
#include "core/surface/seeding/start_pieces.hpp"
#include "core/surface/update_components.hpp"

namespace thaw {

/// Buffers and lists of an update, reused. They are not part of the state.
struct SurfaceTools {
  SortBuffers sort;
  MeshLoader load;      ///< loads the bodies' meshes; set before startSurface
  RowLists surfelsOf;   ///< neighbours of surfels that resampling inspects
  ActiveSet activeSet;  ///< active set of later rounds
  TopologyTools topology;
  RelaxTools relax;  ///< for displacement and iterations
  /// labels, ascending, of liquids whose close sheets startSurface has merged
  std::vector<std::uint64_t> mergedSheets;
  /// bodies with several pieces at the start, although no layer is missing between them
  std::vector<BodyPieces> pieces;
  SurfaceTimes times;  ///< all updates of this process, without the start
};

/// Makes the first surface of the bodies. Requires: Surface without surfels; particles in place. Collective.
void startSurface(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Moves the surfels with the particles, relaxes them, and splits and merges components. The same bits on any
/// number of ranks. Collective.
void updateSurface(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
