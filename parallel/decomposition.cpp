#include "parallel/decomposition.hpp"

#include <algorithm>
#include <cstring>

#include "parallel/sparse_exchange.hpp"

namespace thaw {
namespace {

/// Ranks [first, first + count) share a box.
struct Group { int first, count; CellBox box; };

/// The position of the cut along an axis: the plane where the weight below it comes nearest to `target`, found by bisection of the
/// position with one small reduction a level.
int cutPosition(MPI_Comm comm, const std::vector<WeightedCell>& cells, int axis, int low, int high, std::int64_t target) {
  const auto below = [&](int at) {
    std::int64_t sum = 0;
    for (const WeightedCell& c : cells)
      if (c.cell[axis] < at) sum += c.weight;
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_INT64_T, MPI_SUM, comm);
    return sum;
  };
  int a = low, b = high;  // below(a) <= target
  while (b - a > 1) {
    const int middle = a + (b - a) / 2;
    (below(middle) <= target ? a : b) = middle;
  }
  const std::int64_t underA = target - below(a), overB = below(b) - target;
  return overB < underA ? b : a;
}

}  // namespace

std::vector<CellBox> bisect(const Communicator& comm, const CellGrid& grid, std::vector<WeightedCell> cells, std::int64_t* ownWeight) {
  Group group{0, comm.size(), {{0, 0, 0}, grid.cells}};
  MPI_Comm level;
  MPI_Comm_dup(comm.handle(), &level);
  while (group.count > 1) {
    std::int64_t bounds[6] = {INT64_MIN, INT64_MIN, INT64_MIN, INT64_MIN, INT64_MIN, INT64_MIN}, total = 0;
    for (const WeightedCell& c : cells) {
      total += c.weight;
      for (int a = 0; a < 3; a++) {
        bounds[a] = std::max<std::int64_t>(bounds[a], -c.cell[a]);
        bounds[3 + a] = std::max<std::int64_t>(bounds[3 + a], c.cell[a] + 1);
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, bounds, 6, MPI_INT64_T, MPI_MAX, level);
    MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_INT64_T, MPI_SUM, level);
    int axis = 0, low = 0, high = 0;
    for (int a = 0; a < 3; a++) {
      const bool occupied = total > 0;
      const int l = occupied ? static_cast<int>(-bounds[a]) : group.box.min[a], h = occupied ? static_cast<int>(bounds[3 + a]) : group.box.max[a];
      if (a == 0 || h - l > high - low) axis = a, low = l, high = h;
    }
    const int left = group.count / 2;
    int cut = low + static_cast<int>(static_cast<std::int64_t>(high - low) * left / group.count);
    if (total > 0) cut = cutPosition(level, cells, axis, low, high, static_cast<std::int64_t>(static_cast<double>(total) * left / group.count));
    // cells go to a rank of the half that owns them, spread evenly
    const bool mineIsLeft = comm.rank() < group.first + left;
    std::vector<Message> out;
    std::vector<WeightedCell> keep, give;
    for (const WeightedCell& c : cells) ((c.cell[axis] < cut) == mineIsLeft ? keep : give).push_back(c);
    MPI_Comm_free(&level);
    if (!give.empty()) {
      const int first = mineIsLeft ? group.first + left : group.first, count = mineIsLeft ? group.count - left : left;
      Message m;
      m.rank = first + (comm.rank() - group.first) % count;
      m.bytes.resize(give.size() * sizeof(WeightedCell));
      std::memcpy(m.bytes.data(), give.data(), m.bytes.size());
      out.push_back(std::move(m));
    }
    // every rank of the run is at the same depth or done: ranks that are done take part in the loop below
    for (const Message& m : sparseExchange(comm, out, 101)) {
      const std::size_t n = m.bytes.size() / sizeof(WeightedCell), at = keep.size();
      keep.resize(at + n);
      std::memcpy(keep.data() + at, m.bytes.data(), m.bytes.size());
    }
    cells = std::move(keep);
    if (mineIsLeft) {
      group.count = left;
      group.box.max[axis] = cut;
    } else {
      group.first += left;
      group.count -= left;
      group.box.min[axis] = cut;
    }
    MPI_Comm_split(comm.handle(), group.first, comm.rank(), &level);
  }
  // ranks reach their single box at different depths: keep the others' collective calls company
  int depth = 0, deepest = 0;
  for (int n = comm.size(); n > 1; n = n - n / 2) deepest++;
  {
    Group g{0, comm.size(), {}};
    while (g.count > 1) {
      const int left = g.count / 2;
      if (comm.rank() < g.first + left) g.count = left;
      else g.first += left, g.count -= left;
      depth++;
    }
  }
  for (; depth < deepest; depth++) {
    MPI_Comm_free(&level);
    sparseExchange(comm, {}, 101);
    MPI_Comm_split(comm.handle(), group.first, comm.rank(), &level);
  }
  MPI_Comm_free(&level);
  if (ownWeight != nullptr) {
    *ownWeight = 0;
    for (const WeightedCell& c : cells) *ownWeight += c.weight;
  }
  std::vector<CellBox> boxes(static_cast<std::size_t>(comm.size()));
  MPI_Allgather(&group.box, sizeof(CellBox), MPI_BYTE, boxes.data(), sizeof(CellBox), MPI_BYTE, comm.handle());
  return boxes;
}

int ownerOf(std::span<const CellBox> boxes, const Vec3i& cell, int guess) {
  if (boxes[static_cast<std::size_t>(guess)].contains(cell)) return guess;
  for (std::size_t r = 0; r < boxes.size(); r++)
    if (boxes[r].contains(cell)) return static_cast<int>(r);
  return -1;
}

}  // namespace thaw
