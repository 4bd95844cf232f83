#include "parallel/cell_halo.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string_view>

#include "parallel/sparse_exchange.hpp"

namespace thaw {
namespace {

enum Tag { GhostTag = 11, GhostRestTag = 12, RefreshTag = 13, MigrateKind = 20 };

CellBox grown(CellBox b) {
  for (int a = 0; a < 3; a++) b.min[a]--, b.max[a]++;
  return b;
}
CellBox moved(CellBox b, const Vec3i& by) { return {b.min + by, b.max + by}; }
CellBox common(const CellBox& a, const CellBox& b) {
  CellBox c;
  for (int k = 0; k < 3; k++) c.min[k] = std::max(a.min[k], b.min[k]), c.max[k] = std::min(a.max[k], b.max[k]);
  return c;
}

template<class T> void append(std::vector<std::byte>& to, const T* values, std::size_t n) {
  const std::size_t at = to.size();
  to.resize(at + n * sizeof(T));
  if (n > 0) std::memcpy(to.data() + at, values, n * sizeof(T));
}

std::size_t bytesOfColumns(std::span<AnyColumn* const> columns) {
  std::size_t bytes = 0;
  for (const AnyColumn* c : columns) bytes += c->elementBytes;
  return bytes;
}

template<class Word> void gather(const std::byte* from, std::byte* to, const std::vector<std::uint32_t>& rows) {
  const Word* in = reinterpret_cast<const Word*>(from);
  for (std::size_t k = 0; k < rows.size(); k++) std::memcpy(to + k * sizeof(Word), &in[rows[k]], sizeof(Word));
}
struct Three { std::uint64_t word[3]; };

}  // namespace

MpiCellHalo::MpiCellHalo(const Communicator& comm, const CellGrid& grid, const BalanceRule& rule) : comm_(comm), grid_(grid), rule_(rule) {
  boxes_ = bisect(comm_, grid_, {});
  findNeighbours();
}

void MpiCellHalo::findNeighbours() {
  box_ = boxes_[static_cast<std::size_t>(comm_.rank())];
  neighbours_.clear();
  if (box_.empty()) return;
  for (std::size_t r = 0; r < boxes_.size(); r++) {
    if (boxes_[r].empty()) continue;
    Neighbour n;
    n.rank = static_cast<int>(r);
    Vec3i s;
    for (s.z = -1; s.z <= 1; s.z++)
      for (s.y = -1; s.y <= 1; s.y++)
        for (s.x = -1; s.x <= 1; s.x++) {
          const bool still = s == Vec3i{};
          if ((still && n.rank == comm_.rank()) || (s.x && !grid_.periodic[0]) || (s.y && !grid_.periodic[1]) || (s.z && !grid_.periodic[2])) continue;
          // our cell c appears at c + s * cells to them
          const Vec3i back{-s.x * grid_.cells.x, -s.y * grid_.cells.y, -s.z * grid_.cells.z};
          const CellBox region = common(box_, moved(grown(boxes_[r]), back));
          if (!region.empty()) n.links.push_back({region, s});
        }
    if (!n.links.empty()) neighbours_.push_back(std::move(n));
  }
}

bool MpiCellHalo::inner(std::uint64_t key) const {
  const Vec3i c = cellOfKey(key);
  for (int a = 0; a < 3; a++) {
    const bool low = c[a] > box_.min[a] || (box_.min[a] == 0 && !grid_.periodic[a]);
    const bool high = c[a] < box_.max[a] - 1 || (box_.max[a] == grid_.cells[a] && !grid_.periodic[a]);
    if (!low || !high) return false;
  }
  return true;
}

Migration MpiCellHalo::migrate(Table& p, std::span<const std::uint64_t> keys) {
  Migration m;
  std::vector<Message> out;
  const std::size_t bytes = p.stateBytes();
  int guess = comm_.rank();
  std::vector<std::vector<std::byte>*> to;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3i c = cellOfKey(keys[i]);
    if (box_.contains(c)) continue;
    guess = ownerOf(boxes_, c, guess);
    m.departed.push_back(static_cast<std::uint32_t>(i));
    m.departedTo.push_back(guess);
    auto at = std::find_if(out.begin(), out.end(), [&](const Message& x) { return x.rank == guess && x.bytes.size() + bytes <= (1u << 30); });
    if (at == out.end()) at = out.insert(out.end(), Message{guess, {}});
    const std::size_t end = at->bytes.size();
    at->bytes.resize(end + bytes);
    p.packState(i, at->bytes.data() + end);
  }
  for (const Message& x : out) traffic_.messages++, traffic_.bytes += static_cast<std::int64_t>(x.bytes.size());
  for (const Message& x : sparseExchange(comm_, out, MigrateKind)) {
    const std::size_t n = x.bytes.size() / bytes, first = p.owned;
    p.resize(first + n, 0);
    for (std::size_t k = 0; k < n; k++) p.unpackState(first + k, x.bytes.data() + k * bytes);
    m.arrivals += n;
  }
  return m;
}

void MpiCellHalo::listCells(const CellTable& cells) {
  for (Neighbour& n : neighbours_) {
    n.keys.clear();
    n.counts.clear();
    n.rows.clear();
    n.shift.clear();
  }
  if (neighbours_.empty()) return;
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    if (inner(cells.key[c])) continue;
    const Vec3i cell = cellOfKey(cells.key[c]);
    for (Neighbour& n : neighbours_)
      for (std::size_t l = 0; l < n.links.size(); l++) {
        const Link& link = n.links[l];
        if (!link.region.contains(cell)) continue;
        n.keys.push_back(cellKey({cell.x + link.shift.x * grid_.cells.x, cell.y + link.shift.y * grid_.cells.y, cell.z + link.shift.z * grid_.cells.z}));
        n.counts.push_back(cells.count[c]);
        for (std::uint32_t k = 0; k < cells.count[c]; k++) {
          n.rows.push_back(cells.first[c] + k);
          n.shift.push_back(static_cast<std::uint8_t>(l));
        }
      }
  }
}

void MpiCellHalo::pack(Neighbour& n, std::span<AnyColumn* const> columns, std::byte* to) const {
  for (const AnyColumn* c : columns) {
    switch (c->elementBytes) {
      case 24: gather<Three>(c->bytes.data(), to, n.rows); break;
      case 8: gather<std::uint64_t>(c->bytes.data(), to, n.rows); break;
      case 4: gather<std::uint32_t>(c->bytes.data(), to, n.rows); break;
      case 2: gather<std::uint16_t>(c->bytes.data(), to, n.rows); break;
      case 1: gather<std::uint8_t>(c->bytes.data(), to, n.rows); break;
      default:
        for (std::size_t k = 0; k < n.rows.size(); k++) std::memcpy(to + k * c->elementBytes, c->bytes.data() + n.rows[k] * c->elementBytes, c->elementBytes);
    }
    if (std::string_view(c->name) == "position")
      for (std::size_t k = 0; k < n.rows.size(); k++) {
        const Vec3i& s = n.links[n.shift[k]].shift;
        if (s == Vec3i{}) continue;
        Vec3d x;
        std::memcpy(&x, to + k * sizeof x, sizeof x);
        x += Vec3d{s.x * grid_.period.x, s.y * grid_.period.y, s.z * grid_.period.z};
        std::memcpy(to + k * sizeof x, &x, sizeof x);
      }
    to += n.rows.size() * c->elementBytes;
  }
}

void MpiCellHalo::unpack(const Neighbour& n, const std::byte* from) const {
  for (AnyColumn* c : columns_) {
    const std::size_t bytes = n.ghostCount * c->elementBytes;
    if (bytes > 0) std::memcpy(c->bytes.data() + n.ghostFirst * c->elementBytes, from, bytes);
    from += bytes;
  }
}

// Message: total bytes, number of cells, keys, counts, then each column. Both ends know how large the receiver's buffer is; a
// larger message is announced by its first word alone and sent behind.
void MpiCellHalo::beginGhosts(Table& p, const CellTable& cells, std::span<AnyColumn* const> columns) {
  (void)p;
  columns_.assign(columns.begin(), columns.end());
  listCells(cells);
  for (Neighbour& n : neighbours_) {
    if (n.rank != comm_.rank()) {
      n.in.resize(n.receiveRoom);
      MPI_Irecv(n.in.data(), static_cast<int>(n.receiveRoom), MPI_BYTE, n.rank, GhostTag, comm_.handle(), &n.requests[0]);
    }
  }
  for (Neighbour& n : neighbours_) {
    n.out.clear();
    const std::uint64_t head[2] = {16 + n.keys.size() * 12 + n.rows.size() * bytesOfColumns(columns), n.keys.size()};
    append(n.out, head, 2);
    append(n.out, n.keys.data(), n.keys.size());
    append(n.out, n.counts.data(), n.counts.size());
    const std::size_t at = n.out.size();
    n.out.resize(head[0]);
    pack(n, columns, n.out.data() + at);
    if (n.rank == comm_.rank()) continue;
    traffic_.messages++;
    traffic_.bytes += static_cast<std::int64_t>(n.out.size());
    if (n.out.size() <= n.sendRoom) {
      MPI_Isend(n.out.data(), static_cast<int>(n.out.size()), MPI_BYTE, n.rank, GhostTag, comm_.handle(), &n.requests[1]);
    } else {
      MPI_Send(n.out.data(), 8, MPI_BYTE, n.rank, GhostTag, comm_.handle());
      MPI_Isend(n.out.data(), static_cast<int>(n.out.size()), MPI_BYTE, n.rank, GhostRestTag, comm_.handle(), &n.requests[1]);
      n.sendRoom = n.out.size() + n.out.size() / 4;
    }
  }
}

void MpiCellHalo::finishGhosts(Table& p, CellTable& cells) {
  std::size_t ghosts = 0;
  for (Neighbour& n : neighbours_) {
    if (n.rank == comm_.rank()) {
      n.in.swap(n.out);
    } else {
      MPI_Wait(&n.requests[0], MPI_STATUS_IGNORE);
      std::uint64_t total;
      std::memcpy(&total, n.in.data(), 8);
      if (total > n.receiveRoom) {
        n.in.resize(total);
        MPI_Recv(n.in.data(), static_cast<int>(total), MPI_BYTE, n.rank, GhostRestTag, comm_.handle(), MPI_STATUS_IGNORE);
        n.receiveRoom = total + total / 4;
      }
    }
    std::uint64_t count;
    std::memcpy(&count, n.in.data() + 8, 8);
    n.ghostCount = 0;
    for (std::size_t c = 0; c < count; c++) {
      std::uint32_t k;
      std::memcpy(&k, n.in.data() + 16 + 8 * count + 4 * c, 4);
      n.ghostCount += k;
    }
    n.ghostFirst = p.owned + ghosts;
    ghosts += n.ghostCount;
  }
  p.resize(p.owned, ghosts);
  for (Neighbour& n : neighbours_) {
    std::uint64_t count;
    std::memcpy(&count, n.in.data() + 8, 8);
    std::size_t row = n.ghostFirst;
    for (std::size_t c = 0; c < count; c++) {
      std::uint64_t key;
      std::uint32_t k;
      std::memcpy(&key, n.in.data() + 16 + 8 * c, 8);
      std::memcpy(&k, n.in.data() + 16 + 8 * count + 4 * c, 4);
      cells.key.push_back(key);
      cells.first.push_back(static_cast<std::uint32_t>(row));
      cells.count.push_back(k);
      row += k;
    }
    unpack(n, n.in.data() + 16 + 12 * count);
    if (n.requests[1] != MPI_REQUEST_NULL) MPI_Wait(&n.requests[1], MPI_STATUS_IGNORE);
  }
  // ascending by key: owned cells are already, ghosts are sorted and merged
  cellOrder_.resize(cells.key.size());
  std::iota(cellOrder_.begin(), cellOrder_.end(), 0u);
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return cells.key[a] < cells.key[b]; };
  const auto middle = cellOrder_.begin() + static_cast<std::ptrdiff_t>(cells.ownedCells);
  std::sort(middle, cellOrder_.end(), before);
  std::inplace_merge(cellOrder_.begin(), middle, cellOrder_.end(), before);
  merged_.key.clear();
  merged_.first.clear();
  merged_.count.clear();
  for (std::uint32_t c : cellOrder_) {
    merged_.key.push_back(cells.key[c]);
    merged_.first.push_back(cells.first[c]);
    merged_.count.push_back(cells.count[c]);
  }
  cells.key.swap(merged_.key);
  cells.first.swap(merged_.first);
  cells.count.swap(merged_.count);
}

void MpiCellHalo::beginRefresh(Table& p, std::span<AnyColumn* const> columns) {
  (void)p;
  columns_.assign(columns.begin(), columns.end());
  const std::size_t row = bytesOfColumns(columns);
  for (Neighbour& n : neighbours_) {
    n.out.resize(n.rows.size() * row);
    n.in.resize(n.ghostCount * row);
    pack(n, columns, n.out.data());
    if (n.rank == comm_.rank()) continue;
    MPI_Irecv(n.in.data(), static_cast<int>(n.in.size()), MPI_BYTE, n.rank, RefreshTag, comm_.handle(), &n.requests[0]);
    MPI_Isend(n.out.data(), static_cast<int>(n.out.size()), MPI_BYTE, n.rank, RefreshTag, comm_.handle(), &n.requests[1]);
    traffic_.messages++;
    traffic_.bytes += static_cast<std::int64_t>(n.out.size());
  }
}

void MpiCellHalo::finishRefresh(Table&) {
  for (Neighbour& n : neighbours_) {
    if (n.rank == comm_.rank()) n.in.swap(n.out);
    else MPI_Waitall(2, n.requests, MPI_STATUSES_IGNORE);
    unpack(n, n.in.data());
  }
}

bool MpiCellHalo::rebalance(const CellTable& cells, std::span<const double> cost, bool force) {
  if (comm_.size() == 1) return false;
  double sum = 0;
  for (double c : cost) sum += c;
  double largest = sum, total = sum;
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, comm_.handle());
  MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_DOUBLE, MPI_SUM, comm_.handle());
  if (!(total > 0)) return false;
  const double now = largest * comm_.size() / total;
  if (!force && now < rule_.threshold) return false;
  std::vector<WeightedCell> weighted;
  const double scale = 1e15 / total;  // sums of integers stay below 2^63
  for (std::size_t c = 0; c < cost.size(); c++) weighted.push_back({cellOfKey(cells.key[c]), std::max<std::int64_t>(1, static_cast<std::int64_t>(cost[c] * scale))});
  std::int64_t own = 0;
  std::vector<CellBox> boxes = bisect(comm_, grid_, std::move(weighted), &own);
  std::int64_t most = own, all = own;
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, comm_.handle());
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT64_T, MPI_SUM, comm_.handle());
  const double then = static_cast<double>(most) * comm_.size() / static_cast<double>(all);
  if (!force && then > rule_.gain * now) return false;
  boxes_ = std::move(boxes);
  findNeighbours();
  return true;
}

}  // namespace thaw
