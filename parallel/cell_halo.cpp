// SPDX-License-Identifier: Apache-2.0
#include "parallel/cell_halo.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "core/particles/continuum.hpp"
#include "parallel/transfer.hpp"

namespace thaw {
namespace {

enum Tag { GhostTag = 11, GhostRestTag = 12, RefreshTag = 13, MigrateKind = 20 };

/// Adds room for longer messages in later steps.
std::size_t withRoom(std::size_t bytes) { return bytes + bytes / 16; }

/// Grows a buffer; its old contents, already sent or read, are lost.
void fit(std::vector<std::byte>& buffer, std::size_t bytes, std::size_t room) {
  if (bytes <= buffer.size()) return;
  buffer = {};
  buffer.resize(room);
}

// A ghost message: its bytes, the number of cells, their keys, their particle counts, the columns.
struct GhostHead {
  std::uint64_t bytes, cells;
};
constexpr std::size_t bytesPerCell = sizeof(std::uint64_t) + sizeof(std::uint32_t);

GhostHead headOf(const std::vector<std::byte>& message) {
  GhostHead head;
  std::memcpy(&head, message.data(), sizeof head);
  return head;
}

}  // namespace

MpiCellHalo::MpiCellHalo(const Communicator& comm, const CellGrid& grid, const BalanceRule& rule)
    : comm_(comm), grid_(grid), rule_(rule), messageTo_(static_cast<std::size_t>(comm.size()), -1) {
  checkPeriodicCells(grid_);
  usePartition(Partition(bisect(comm_, grid_, {})));
}

void MpiCellHalo::usePartition(Partition partition) {
  partition_ = std::move(partition);
  newPartition_ = true;
  box_ = partition_.box(comm_.rank());
  neighbours_.clear();
  for (int r = 0; r < comm_.size(); r++) {
    Neighbour n;
    n.rank = r;
    n.sendRoom = n.receiveRoom = std::min<std::size_t>(1 << 16, comm_.chunk());
    n.copies.links = imageLinks(grid_, box_, partition_.box(r), r == comm_.rank());
    if (!n.copies.links.empty()) neighbours_.push_back(std::move(n));
  }
}

std::size_t MpiCellHalo::bufferBytes() const {
  std::size_t n = boundary_.capacity() * sizeof(std::uint32_t);
  for (const Neighbour& x : neighbours_) {
    n += x.out.capacity() + x.in.capacity();
    n += x.copies.keys.capacity() * sizeof(std::uint64_t) +
         x.copies.counts.capacity() * sizeof(std::uint32_t) + x.copies.runs.capacity() * sizeof(RowRun);
  }
  for (const Message& x : movers_) n += x.bytes.capacity();
  for (const Message& x : receiveBuffer_.messages()) n += x.bytes.capacity();
  return n;
}

Migration MpiCellHalo::migrate(Table& p, std::span<const std::uint64_t> keys) {
  Migration m;
  p.resize(p.owned, 0);
  if (comm_.size() == 1) return m;
  const std::size_t bytes = p.stateBytes();
  for (Message& x : movers_) x.bytes.clear();
  std::size_t used = 0;
  int to = comm_.rank();
  std::uint64_t ours = 0;  // the last cell that stays: rows are sorted, so most are in the cell of the row
                           // before
  for (std::size_t i = 0; i < p.owned; i++) {
    if (keys[i] == ours || keys[i] == noCell) continue;
    const Vec3i cell = cellOfKey(keys[i]);
    if (box_.contains(cell)) {
      ours = keys[i];
      continue;
    }
    to = partition_.owner(cell, to < 0 ? comm_.rank() : to);
    if (to < 0) throw std::logic_error("migrate: a particle's cell is outside of the grid");
    m.departed.push_back(static_cast<std::uint32_t>(i));
    m.departedTo.push_back(to);
    int& at = messageTo_[static_cast<std::size_t>(to)];
    if (at < 0) {
      if (used == movers_.size()) movers_.emplace_back();
      at = static_cast<int>(used++);
      movers_[static_cast<std::size_t>(at)].rank = to;
    }
    std::vector<std::byte>& out = movers_[static_cast<std::size_t>(at)].bytes;
    out.resize(out.size() + bytes);
    p.packState(i, out.data() + out.size() - bytes);
  }
  for (std::size_t k = 0; k < used; k++) messageTo_[static_cast<std::size_t>(movers_[k].rank)] = -1;
  sparseExchange(comm_, {movers_.data(), used}, receiveBuffer_, MigrateKind, MessagesFor::Migration);
  const std::size_t before = p.owned;
  for (const Message& x : receiveBuffer_.messages()) m.arrivals += x.bytes.size() / bytes;
  if (m.arrivals > 0) {
    p.resize(before + m.arrivals, 0);
    std::size_t row = before;
    for (const Message& x : receiveBuffer_.messages())
      for (std::size_t at = 0; at < x.bytes.size(); at += bytes) p.unpackState(row++, x.bytes.data() + at);
    // solid_index refers to a table of the old owner.
    if (AnyColumn* solidIndex = p.find("solid_index"); solidIndex != nullptr && solidIndex->active)
      std::fill_n(reinterpret_cast<std::uint32_t*>(solidIndex->bytes.data()) + before, m.arrivals, noSolid);
  }
  if (newPartition_) {  // later migrations are smaller
    movers_ = {};
    receiveBuffer_ = {};
    newPartition_ = false;
  }
  return m;
}

/// Bytes to receive at once after a message of this size. They are at most one chunk, since the number of
/// chunks of the next message is unknown.
std::size_t MpiCellHalo::roomFor(std::size_t bytes) const { return std::min(withRoom(bytes), comm_.chunk()); }

void MpiCellHalo::beginGhosts(Table&, const CellTable& cells, std::span<AnyColumn* const> columns) {
  mark_.begin(comm_, MessagesFor::Ghosts);
  chooseColumns(columns, columns_);
  for (Neighbour& n : neighbours_) {
    if (n.rank == comm_.rank()) continue;
    fit(n.in, n.receiveRoom, n.receiveRoom);
    startReceive(comm_, {n.in.data(), n.receiveRoom}, {n.rank, GhostTag}, n.receiving);
  }
  if (neighbours_.empty()) return;
  listBoundary(grid_, box_, cells, boundary_);
  for (Neighbour& n : neighbours_) sendGhosts(n, cells);
}

// Both ends store the receiver's buffer size. Before a larger message, its head is sent alone.
void MpiCellHalo::sendGhosts(Neighbour& n, const CellTable& cells) {
  CellCopies& c = n.copies;
  listCopies(grid_, cells, boundary_, c);
  const GhostHead head{sizeof(GhostHead) + c.keys.size() * bytesPerCell + c.rows * bytesOfColumns(columns_),
                       c.keys.size()};
  fit(n.out, head.bytes, withRoom(head.bytes));
  std::byte* to = n.out.data();
  std::memcpy(to, &head, sizeof head);
  to += sizeof head;
  if (head.cells > 0) {
    std::memcpy(to, c.keys.data(), c.keys.size() * sizeof(std::uint64_t));
    to += c.keys.size() * sizeof(std::uint64_t);
    std::memcpy(to, c.counts.data(), c.counts.size() * sizeof(std::uint32_t));
    to += c.counts.size() * sizeof(std::uint32_t);
    packColumns(grid_, c, columns_, to);
  }
  if (n.rank == comm_.rank()) return;
  if (head.bytes <= n.sendRoom) {
    startSend(comm_, {n.out.data(), head.bytes}, {n.rank, GhostTag}, MessagesFor::Ghosts, n.sending);
  } else {
    startSend(comm_, {n.out.data(), sizeof head}, {n.rank, GhostTag}, MessagesFor::Ghosts, n.sending);
    startSend(comm_, {n.out.data(), head.bytes}, {n.rank, GhostRestTag}, MessagesFor::Ghosts, n.sending);
    n.sendRoom = roomFor(head.bytes);
  }
}

void MpiCellHalo::receiveGhosts(Neighbour& n) {
  if (n.rank == comm_.rank()) {
    n.in.swap(n.out);
  } else {
    finishAll(n.receiving);
    const std::size_t bytes = headOf(n.in).bytes;
    if (bytes > n.receiveRoom) {
      fit(n.in, bytes, withRoom(bytes));
      startReceive(comm_, {n.in.data(), bytes}, {n.rank, GhostRestTag}, n.receiving);
      finishAll(n.receiving);
      n.receiveRoom = roomFor(bytes);
    }
  }
}

/// Appends the cells of a received message to the table; their rows begin at n.ghostFirst. Returns the
/// number of rows.
std::size_t MpiCellHalo::appendCells(const Neighbour& n, CellTable& cells) const {
  const std::size_t count = headOf(n.in).cells, at = cells.key.size();
  cells.key.resize(at + count);
  cells.first.resize(at + count);
  cells.count.resize(at + count);
  if (count == 0) return 0;
  const std::byte* const from = n.in.data() + sizeof(GhostHead);
  std::memcpy(cells.key.data() + at, from, count * sizeof(std::uint64_t));
  std::memcpy(cells.count.data() + at, from + count * sizeof(std::uint64_t), count * sizeof(std::uint32_t));
  std::size_t row = n.ghostFirst;
  for (std::size_t c = at; c < at + count; c++) {
    cells.first[c] = static_cast<std::uint32_t>(row);
    row += cells.count[c];
  }
  return row - n.ghostFirst;
}

void MpiCellHalo::finishGhosts(Table& p, CellTable& cells) {
  std::size_t row = p.owned;
  for (Neighbour& n : neighbours_) {
    {
      const WaitMark waiting(comm_, MessagesFor::Ghosts);
      receiveGhosts(n);
    }
    n.ghostFirst = row;
    n.ghostCount = appendCells(n, cells);
    row += n.ghostCount;
  }
  p.resize(p.owned, row - p.owned);
  for (Neighbour& n : neighbours_) {
    unpackColumns(columns_, n.ghostFirst, n.ghostCount,
                  n.in.data() + sizeof(GhostHead) + headOf(n.in).cells * bytesPerCell);
    finishAll(n.sending);
  }
  mark_.end(comm_, MessagesFor::Ghosts);
  merge_.merge(cells);
}

void MpiCellHalo::beginRefresh(Table&, std::span<AnyColumn* const> columns) {
  mark_.begin(comm_, MessagesFor::Refresh);
  chooseColumns(columns, columns_);
  const std::size_t row = bytesOfColumns(columns_);
  for (Neighbour& n : neighbours_) {
    fit(n.in, n.ghostCount * row, withRoom(n.ghostCount * row));
    if (n.rank != comm_.rank())
      startReceive(comm_, {n.in.data(), n.ghostCount * row}, {n.rank, RefreshTag}, n.receiving);
  }
  for (Neighbour& n : neighbours_) {
    fit(n.out, n.copies.rows * row, withRoom(n.copies.rows * row));
    packColumns(grid_, n.copies, columns_, n.out.data());
    if (n.rank != comm_.rank())
      startSend(comm_, {n.out.data(), n.copies.rows * row}, {n.rank, RefreshTag}, MessagesFor::Refresh,
                n.sending);
  }
}

void MpiCellHalo::finishRefresh(Table&) {
  for (Neighbour& n : neighbours_) {
    if (n.rank == comm_.rank()) {
      n.in.swap(n.out);
    } else {
      const WaitMark waiting(comm_, MessagesFor::Refresh);
      finishAll(n.receiving);
      finishAll(n.sending);
    }
    unpackColumns(columns_, n.ghostFirst, n.ghostCount, n.in.data());
  }
  mark_.end(comm_, MessagesFor::Refresh);
}

// Costs are measured times. They are converted to integers of a common unit, so that all ranks compute the
// same sums and the same partition.
bool MpiCellHalo::rebalance(const CellTable& cells, std::span<const double> cost, bool force) {
  if (comm_.size() == 1) return false;
  const auto usable = [](double c) { return c > 0 && c < std::numeric_limits<double>::max() ? c : 0.0; };
  const bool merged = cells.key.size() != cost.size();  // includes ghost cells, which their owners contribute
  std::vector<WeightedCell> weighted;
  weighted.reserve(cost.size());
  for (std::uint64_t key : cells.key)
    if (!merged || owns(key)) weighted.push_back({cellOfKey(key), 0});
  if (weighted.size() != cost.size())
    throw std::logic_error("rebalance: there must be one cost for each owned cell");
  double largest = 0;
  for (double c : cost) largest += usable(c);
  MpiReducer all(comm_);
  all.maximum({&largest, 1});
  if (!(largest > 0)) return false;
  const double unit = largest / 0x1p40;  // sums over ranks stay below 2^63
  std::int64_t here = 0;
  for (std::size_t c = 0; c < cost.size(); c++) {
    weighted[c].weight = std::max<std::int64_t>(1, static_cast<std::int64_t>(usable(cost[c]) / unit));
    here += weighted[c].weight;
  }
  const auto imbalance = [&](std::int64_t own) {
    double most = static_cast<double>(own);  // exact, below 2^53
    std::int64_t total = own;
    all.maximum({&most, 1});
    all.sum({&total, 1});
    return most * comm_.size() / static_cast<double>(total);
  };
  imbalance_ = imbalance(here);
  if (!force && (pause_ > 0 || imbalance_ < rule_.threshold)) {
    pause_ = std::max(0, pause_ - 1);
    return false;
  }
  pause_ = force ? 0 : rule_.pause;
  std::int64_t own = 0;
  std::vector<CellBox> boxes = bisect(comm_, grid_, std::move(weighted), &own);
  const double then = imbalance(own);
  if (!force && then > rule_.gain * imbalance_) return false;
  imbalance_ = then;
  usePartition(Partition(std::move(boxes)));
  return true;
}

void MpiCellHalo::follow(const CellHalo& leader) {
  const Partition& other = dynamic_cast<const MpiCellHalo&>(leader).partition_;
  if (other.boxes() != partition_.boxes()) usePartition(other);
}

}  // namespace thaw
