// SPDX-License-Identifier: Apache-2.0
// Surface of a body for shrink-wrap: its outer cells, sent to the ranks whose vertices they attract.
#pragma once
#include "core/halo/halo.hpp"

namespace thaw {

/// Cell of the body: total weight (kg or m^2) and weighted centre (m).
struct ShrinkWrapCell {
  std::uint64_t key;
  double share;
  Vec3d middle;
};

/// Force on a cell, in integer multiples of the unit.
struct ShrinkWrapForce {
  std::uint64_t key;
  Vec3<std::int64_t> units;
};

/// Surface cells of a body. A hash assigns blocks of cells to ranks. A block's owner stores its surface cells
/// and their ranks. All ranks store the bounding boxes of surface blocks, 56 bytes each. For a cube of 10^9
/// particles with 8 particles per cell, there are about 23,000 surface blocks (1.3 MB).
struct ShrinkWrapSurface {
  struct Listed {
    ShrinkWrapCell part;
    int home;
  };
  std::vector<Listed> listed;        ///< surface cells of this rank's blocks, with the owners of their rows;
                                     ///< ascending by key
  std::vector<ShrinkWrapCell> near;  ///< cells near this rank's vertices; ascending by key
  bool any = false;                  ///< the body exists; the same on all ranks
};

/// Finds the surface. A cell is on the surface if one of its six neighbours is not a cell of the body. cells:
/// cells of the body on this rank, ascending by key. places: m, this rank's vertices. For each vertex, `near`
/// contains all surface cells at most `beyond` (m) farther than the nearest one. Collective.
ShrinkWrapSurface findShrinkWrapSurface(Reducer& all, const CellGrid& grid,
                                        const std::vector<ShrinkWrapCell>& cells,
                                        const std::vector<Vec3d>& places, double beyond);

/// Sums the forces on the cells in `near` (three components each, in units) over all ranks. Returns the
/// forces on this rank's cells, ascending by key. Collective.
std::vector<ShrinkWrapForce> reduceShrinkWrapForces(Reducer& all, const ShrinkWrapSurface& surface,
                                                    const std::vector<std::int64_t>& units);

}  // namespace thaw
