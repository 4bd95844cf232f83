// SPDX-License-Identifier: Apache-2.0
#include "parallel/decomposition.hpp"

#include <algorithm>
#include <utility>

#include "parallel/transfer.hpp"

namespace thaw {
namespace {

enum Tag { CellsTag = 10 };

/// Ranks [first, first + count) share a box; rank first + i of the run has number i in comm.
struct Group {
  MPI_Comm comm;
  int first, count, self;
  CellBox box;
  const Communicator* all;
};

int leftOf(int count) { return count / 2; }

/// Cost of a plane of ghost cells, in planes of owned cells. A narrow box has more ghost planes per owned
/// plane.
constexpr double ghostWork = 0.3;

struct Cut {
  int axis, position;
};

struct Occupied {
  Vec3i low, high;
  std::int64_t total;
};

Occupied occupied(const Group& g, const std::vector<WeightedCell>& cells) {
  Occupied o{};
  std::int64_t bounds[6];
  for (std::int64_t& b : bounds) b = INT64_MIN;
  for (const WeightedCell& c : cells) {
    o.total += c.weight;
    for (int a = 0; a < 3; a++) {
      bounds[a] = std::max<std::int64_t>(bounds[a], -c.cell[a]);
      bounds[3 + a] = std::max<std::int64_t>(bounds[3 + a], c.cell[a] + 1);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, bounds, 6, MPI_INT64_T, MPI_MAX, g.comm);
  MPI_Allreduce(MPI_IN_PLACE, &o.total, 1, MPI_INT64_T, MPI_SUM, g.comm);
  g.all->statistics().collectives += 2;
  for (int a = 0; a < 3 && o.total > 0; a++) {
    o.low[a] = static_cast<int>(-bounds[a]);
    o.high[a] = static_cast<int>(bounds[3 + a]);
  }
  return o;
}

/// Computes the weight below a plane across each axis.
void weightBelow(const Group& g, const std::vector<WeightedCell>& cells, const Vec3i& plane,
                 std::int64_t (&sum)[3]) {
  for (int a = 0; a < 3; a++) {
    sum[a] = 0;
    for (const WeightedCell& c : cells) sum[a] += c.cell[a] < plane[a] ? c.weight : 0;
  }
  MPI_Allreduce(MPI_IN_PLACE, sum, 3, MPI_INT64_T, MPI_SUM, g.comm);
  g.all->statistics().collectives++;
}

// For each axis, finds the plane that splits the weight best, by bisection of its position. Each level takes
// one small reduction for all axes, for any length of the grid. Then selects the axis whose larger part has
// the least work, ghosts included.
Cut findCut(const Group& g, const std::vector<WeightedCell>& cells) {
  const int left = leftOf(g.count);
  const Occupied o = occupied(g, cells);
  if (o.total == 0) {
    Cut cut{0, 0};
    for (int a = 1; a < 3; a++)
      if (g.box.max[a] - g.box.min[a] > g.box.max[cut.axis] - g.box.min[cut.axis]) cut.axis = a;
    const std::int64_t length = std::max(0, g.box.max[cut.axis] - g.box.min[cut.axis]);
    cut.position = g.box.min[cut.axis] + static_cast<int>(length * left / g.count);
    return cut;
  }
  const std::int64_t target = static_cast<std::int64_t>(static_cast<double>(o.total) * left / g.count);
  Vec3i a = o.low, b = o.high;  // weight below a <= target < weight below b
  std::int64_t belowA[3] = {0, 0, 0}, belowB[3] = {o.total, o.total, o.total}, sum[3];
  const auto wide = [&] { return b.x - a.x > 1 || b.y - a.y > 1 || b.z - a.z > 1; };
  while (wide()) {
    Vec3i middle;
    for (int k = 0; k < 3; k++) middle[k] = a[k] + (b[k] - a[k]) / 2;
    weightBelow(g, cells, middle, sum);
    for (int k = 0; k < 3; k++) {
      if (sum[k] <= target) a[k] = middle[k], belowA[k] = sum[k];
      else b[k] = middle[k], belowB[k] = sum[k];
    }
  }
  Cut best{0, 0};
  double least = 0;
  for (int k = 0; k < 3; k++) {
    const bool upper = belowB[k] - target < target - belowA[k];
    const double below = static_cast<double>(upper ? belowB[k] : belowA[k]),
                 total = static_cast<double>(o.total);
    const double largest = std::max(below / left, (total - below) / (g.count - left)) * g.count / total;
    const double work = largest + 2 * ghostWork / (o.high[k] - o.low[k]);
    if (k == 0 || work < least) {
      least = work;
      best = {k, upper ? b[k] : a[k]};
    }
  }
  return best;
}

/// Number of cells in a chunk of a message. A full chunk is followed by another one, which may be empty.
std::size_t cellsPerChunk(const Group& g) { return g.all->chunk() / sizeof(WeightedCell); }

std::vector<MPI_Request> sendCells(const Group& g, const std::vector<WeightedCell>& give, int to) {
  std::vector<MPI_Request> requests;
  for (std::size_t done = 0; done <= give.size(); done += cellsPerChunk(g)) {
    const std::size_t bytes = std::min(cellsPerChunk(g), give.size() - done) * sizeof(WeightedCell);
    MPI_Isend(give.data() + done, static_cast<int>(bytes), MPI_BYTE, to, CellsTag, g.comm,
              &requests.emplace_back());
    g.all->statistics().sent(MessagesFor::Balance, bytes);
  }
  return requests;
}

void receiveCells(const Group& g, int from, std::vector<WeightedCell>& cells) {
  for (std::size_t came = cellsPerChunk(g); came == cellsPerChunk(g);) {
    MPI_Status status;
    MPI_Probe(from, CellsTag, g.comm, &status);
    int bytes = 0;
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    came = static_cast<std::size_t>(bytes) / sizeof(WeightedCell);
    const std::size_t at = cells.size();
    cells.resize(at + came);
    MPI_Recv(cells.data() + at, bytes, MPI_BYTE, from, CellsTag, g.comm, MPI_STATUS_IGNORE);
  }
}

/// Moves cells to the half that will own them. Every rank sends to one partner in the other half, so all
/// senders are known.
void exchangeHalves(const Group& g, const Cut& cut, std::vector<WeightedCell>& cells) {
  const int left = leftOf(g.count), right = g.count - left;
  const bool mineIsLeft = g.self < left;
  std::vector<WeightedCell> keep, give;
  for (const WeightedCell& c : cells)
    ((c.cell[cut.axis] < cut.position) == mineIsLeft ? keep : give).push_back(c);
  const auto partner = [&](int i) { return i < left ? left + i % right : (i - left) % left; };
  std::vector<MPI_Request> sent = sendCells(g, give, partner(g.self));
  for (int i = mineIsLeft ? left : 0; i < (mineIsLeft ? g.count : left); i++)
    if (partner(i) == g.self) receiveCells(g, i, keep);
  finishAll(sent);
  cells = std::move(keep);
}

CellBox united(const CellBox& a, const CellBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  CellBox u;
  for (int k = 0; k < 3; k++) {
    u.min[k] = std::min(a.min[k], b.min[k]);
    u.max[k] = std::max(a.max[k], b.max[k]);
  }
  return u;
}

}  // namespace

std::vector<CellBox> bisect(const Communicator& comm, const CellGrid& grid, std::vector<WeightedCell> cells,
                            std::int64_t* ownWeight) {
  const WaitMark waiting(comm, MessagesFor::Balance);  // nearly all of the time
  Group g{MPI_COMM_NULL, 0, comm.size(), comm.rank(), {{0, 0, 0}, grid.cells}, &comm};
  MPI_Comm_dup(comm.handle(), &g.comm);
  comm.statistics().collectives++;
  while (g.count > 1) {
    const Cut cut = findCut(g, cells);
    exchangeHalves(g, cut, cells);
    const int left = leftOf(g.count);
    const bool mineIsLeft = g.self < left;
    MPI_Comm half;
    MPI_Comm_split(g.comm, mineIsLeft ? 0 : 1, g.self, &half);
    comm.statistics().collectives++;
    MPI_Comm_free(&g.comm);
    g.comm = half;
    if (mineIsLeft) {
      g.count = left;
      g.box.max[cut.axis] = cut.position;
    } else {
      g.first += left;
      g.self -= left;
      g.count -= left;
      g.box.min[cut.axis] = cut.position;
    }
  }
  MPI_Comm_free(&g.comm);
  if (ownWeight != nullptr) {
    *ownWeight = 0;
    for (const WeightedCell& c : cells) *ownWeight += c.weight;
  }
  std::vector<CellBox> boxes(static_cast<std::size_t>(comm.size()));
  MPI_Allgather(&g.box, sizeof(CellBox), MPI_BYTE, boxes.data(), sizeof(CellBox), MPI_BYTE, comm.handle());
  comm.statistics().collectives++;
  return boxes;
}

Partition::Partition(std::vector<CellBox> boxes) : boxes_(std::move(boxes)) {
  std::size_t nodes = 1;
  for (std::size_t n = boxes_.size(); n > 1; n -= n / 2) nodes = 2 * nodes + 1;
  tree_.resize(nodes);
  cover(0, 0, static_cast<int>(boxes_.size()));
}

CellBox Partition::cover(std::size_t node, int first, int count) {
  const int left = leftOf(count);
  if (count == 1) return tree_[node] = boxes_[static_cast<std::size_t>(first)];
  const CellBox low = cover(2 * node + 1, first, left),
                high = cover(2 * node + 2, first + left, count - left);
  return tree_[node] = united(low, high);
}

int Partition::owner(const Vec3i& cell, int guess) const {
  if (boxes_[static_cast<std::size_t>(guess)].contains(cell)) return guess;
  if (!tree_[0].contains(cell)) return -1;
  std::size_t node = 0;
  int first = 0, count = static_cast<int>(boxes_.size());
  while (count > 1) {
    const int left = leftOf(count);
    if (tree_[2 * node + 1].contains(cell)) {
      node = 2 * node + 1;
      count = left;
    } else {
      node = 2 * node + 2;
      first += left;
      count -= left;
    }
  }
  return first;
}

}  // namespace thaw
