// SPDX-License-Identifier: Apache-2.0
// Buffers of a surface update.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/neighbours/sort.hpp"
#include "core/surface/data/surface_times.hpp"
#include "core/surface/search/active_set.hpp"
#include "core/surface/search/row_lists.hpp"
#include "core/surface/work/relax_tools.hpp"
#include "core/surface/work/topology_tools.hpp"

namespace thaw {

struct BodyPieces {
  std::size_t body = 0;
  std::int64_t pieces = 0;
};

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
  /// bodies with several pieces at the start, although no lattice layer is missing between the pieces
  std::vector<BodyPieces> pieces;
  SurfaceTimes times;  ///< all updates of this process, without the start
};

}  // namespace thaw
