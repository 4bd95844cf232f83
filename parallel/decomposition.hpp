// Who owns which cells: every rank a box of whole cells; the boxes tile the grid (weighted recursive
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

/// Bisects the grid among all ranks so that the weights (> 0) are as even as whole planes of cells allow.
/// Each rank brings the occupied cells it knows of, in any distribution; the weights of a cell that several
/// ranks bring add up. The cells travel to the half that will own them, level by level. ownWeight: what this
/// rank will have. Without cells, boxes of about equal size. Returns the boxes of all ranks. Collective.
std::vector<CellBox> bisect(const Communicator& comm, const CellGrid& grid, std::vector<WeightedCell> cells,
                            std::int64_t* ownWeight = nullptr);

/// The boxes of all ranks, with the tree of cuts for looking up a cell's owner in O(log ranks).
class Partition {
 public:
  Partition() = default;
  explicit Partition(std::vector<CellBox> boxes);  ///< as bisect makes them
  const std::vector<CellBox>& boxes() const { return boxes_; }
  const CellBox& box(int rank) const { return boxes_[static_cast<std::size_t>(rank)]; }
  /// The owner of a cell of the grid, -1 for cells outside. guess: a rank that is tried first.
  int owner(const Vec3i& cell, int guess) const;

 private:
  CellBox cover(std::size_t node, int first, int count);
  std::vector<CellBox> boxes_, tree_;  // tree_: boxes of the groups of the bisection, children of n at 2n + 1
                                       // and 2n + 2
};

}  // namespace thaw
