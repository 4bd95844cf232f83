// SPDX-License-Identifier: Apache-2.0
// Ownership of cells: each rank has a box of whole cells, and the boxes tile the grid (weighted recursive
// bisection).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/cell_box.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

struct WeightedCell {
  Vec3i cell;
  std::int64_t weight;
};

/// Bisects the grid among all ranks such that the weights (> 0) are as equal as whole planes of cells allow.
/// Each rank contributes any subset of the occupied cells; weights of a cell from several ranks are summed.
/// Cells move level by level to the half that will own them. ownWeight: resulting weight of this rank.
/// Without cells, boxes have about equal size. Returns the boxes of all ranks. Collective.
std::vector<CellBox> bisect(const Communicator& comm, const CellGrid& grid, std::vector<WeightedCell> cells,
                            std::int64_t* ownWeight = nullptr);

/// The boxes of all ranks, with the bisection tree to find the owner of a cell in O(log ranks).
class Partition {
 public:
  Partition() = default;
  explicit Partition(std::vector<CellBox> boxes);  ///< boxes as made by bisect
  const std::vector<CellBox>& boxes() const { return boxes_; }
  const CellBox& box(int rank) const { return boxes_[static_cast<std::size_t>(rank)]; }
  /// Returns the owner of a cell of the grid, -1 for cells outside. guess: rank to check first.
  int owner(const Vec3i& cell, int guess) const;

 private:
  CellBox cover(std::size_t node, int first, int count);
  std::vector<CellBox> boxes_, tree_;  // tree_: boxes of the groups of the bisection, children of n at 2n + 1
                                       // and 2n + 2
};

}  // namespace thaw
