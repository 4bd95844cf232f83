// The surface of a body as a sheet that is wrapped round it sees it: its outer cells, of which each rank has
// those that its own vertices may be drawn to.
#pragma once
#include "core/halo/halo.hpp"

namespace thaw {

/// A cell of the body: what shares in a force on it (its mass, or area), and their middle.
struct WrapPart {
  std::uint64_t key;
  double share;
  Vec3d middle;
};

/// What draws a cell, in whole multiples of a small force.
struct WrapPull {
  std::uint64_t key;
  Vec3<std::int64_t> units;
};

/// Blocks of cells are dealt out to the ranks by a hash of their place: who has one knows its surface, and
/// where its cells are. What all ranks know are the boxes of the blocks on the surface, 56 bytes each: with
/// 10^9 particles in a cube, 8 in a cell, some 23,000 of them, 1.3 MB.
struct WrapSurface {
  struct Listed {
    WrapPart part;
    int home;
  };
  std::vector<Listed> listed;  ///< of this rank's blocks, with the rank whose rows they are; ascending by key
  std::vector<WrapPart> near;  ///< for this rank's vertices; ascending by key
  bool any = false;            ///< is there a body at all? The same on all ranks
};

/// cells: of the body, on this rank, ascending by key. places: of this rank's vertices. Of each, `near` has
/// all cells of the surface that are no more than `beyond` (m) further off than the nearest one. A cell is on
/// the surface if one of the six beside it is not the body's. Collective.
WrapSurface findWrapSurface(Reducer& all, const CellGrid& grid, const std::vector<WrapPart>& cells,
                            const std::vector<Vec3d>& places, double beyond);

/// Sums over all ranks of what draws the parts of `near` (units: three each), for the cells that are this
/// rank's, ascending by key. Collective.
std::vector<WrapPull> returnPulls(Reducer& all, const WrapSurface& surface,
                                  const std::vector<std::int64_t>& units);

}  // namespace thaw
