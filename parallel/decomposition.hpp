// Who owns which cells: every rank a box of whole cells; the boxes tile the grid (weighted recursive bisection).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Cells [min, max) along each axis; empty if max <= min along one.
struct CellBox {
  Vec3i min{}, max{};
  bool contains(const Vec3i& c) const {
    return c.x >= min.x && c.x < max.x && c.y >= min.y && c.y < max.y && c.z >= min.z && c.z < max.z;
  }
  bool empty() const { return max.x <= min.x || max.y <= min.y || max.z <= min.z; }
};

struct WeightedCell { Vec3i cell; std::int64_t weight; };

/// Bisects the grid among all ranks so that the weights are as even as whole planes of cells allow. Each rank brings the
/// occupied cells it knows of, in any distribution, each cell once. The cells travel to the half that will own them, level by level;
/// no rank sees more than its share. ownWeight: what this rank will have. Returns the boxes of all ranks. Collective.
std::vector<CellBox> bisect(const Communicator& comm, const CellGrid& grid, std::vector<WeightedCell> cells, std::int64_t* ownWeight = nullptr);

/// The owner of a cell of the grid.
int ownerOf(std::span<const CellBox> boxes, const Vec3i& cell, int guess);

}  // namespace thaw
