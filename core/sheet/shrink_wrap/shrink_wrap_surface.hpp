// SPDX-License-Identifier: Apache-2.0
// Surface of a body for shrink-wrap: its outer cells, distributed to the ranks whose vertices they attract.
#pragma once
#include "core/halo/halo.hpp"

namespace thaw {

/// Cell of the body: total weight (mass or area) and weighted centre.
struct ShrinkWrapCell {
  std::uint64_t key;
  double share;
  Vec3d middle;
};

/// Force on a cell, in integer units.
struct ShrinkWrapForce {
  std::uint64_t key;
  Vec3<std::int64_t> units;
};

/// Surface cells of a body. A hash assigns blocks of cells to ranks; a block's owner stores its surface and
/// the ranks of its cells. All ranks store the bounding boxes of surface blocks, 56 bytes each. 10^9
/// particles in a cube, 8 in a cell, have about 23,000 such blocks: 1.3 MB.
struct ShrinkWrapSurface {
  struct Listed {
    ShrinkWrapCell part;
    int home;
  };
  std::vector<Listed> listed;  ///< cells of this rank's blocks with the owners of their rows; ascending by
                               ///< key
  std::vector<ShrinkWrapCell> near;  ///< cells near this rank's vertices; ascending by key
  bool any = false;                  ///< true if the body exists; the same on all ranks
};

/// Finds the surface. cells: the body's on this rank, ascending by key. places: this rank's vertices. `near`
/// gets for each vertex all surface cells at most `beyond` (m) farther than its nearest one. A cell is on the
/// surface if one of its six neighbours is not the body's. Collective.
ShrinkWrapSurface findShrinkWrapSurface(Reducer& all, const CellGrid& grid,
                                        const std::vector<ShrinkWrapCell>& cells,
                                        const std::vector<Vec3d>& places, double beyond);

/// Sums the forces on the cells in `near` (three units each) over all ranks. Returns those on this rank's
/// cells, ascending by key. Collective.
std::vector<ShrinkWrapForce> reduceShrinkWrapForces(Reducer& all, const ShrinkWrapSurface& surface,
                                                    const std::vector<std::int64_t>& units);

}  // namespace thaw
