// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "core/fields/column.hpp"

namespace thaw {

AnyColumn::AnyColumn(Table& table, const char* name, const char* unit, Keep keep, const char* about,
                     Scalar scalar, int components, Rows rows)
    : name(name),
      unit(unit),
      about(about),
      keep(keep),
      scalar(scalar),
      components(components),
      elementBytes(bytesOf(scalar) * static_cast<std::size_t>(components)),
      rows(rows) {
  table.columns.push_back(this);
}

std::size_t withHeadRoom(std::size_t rows) {
  const double layer = std::cbrt(static_cast<double>(rows)) * std::cbrt(static_cast<double>(rows));
  return rows + std::min(rows / 16, static_cast<std::size_t>(layer));
}

namespace {

void resizeColumn(AnyColumn& c, std::size_t rows) {
  const std::size_t before = c.bytes.size(), after = rows * c.elementBytes;
  makeRoom(c.bytes, rows, c.elementBytes);
  c.bytes.resize(after);
  if (after > before) std::memset(c.bytes.data() + before, 0, after - before);
}

template<class Word> void gather(const std::byte* from, std::byte* to, std::span<const std::uint32_t> order) {
  const Word* in = reinterpret_cast<const Word*>(from);
  Word* out = reinterpret_cast<Word*>(to);
  for (std::size_t i = 0; i < order.size(); i++) out[i] = in[order[i]];
}
struct Three {
  std::uint64_t word[3];
};

bool contains(std::span<AnyColumn* const> columns, const AnyColumn* c) {
  return std::find(columns.begin(), columns.end(), c) != columns.end();
}

/// Moves runs of one column to their targets. The target of an upward run may overlap later runs, so later
/// upward runs move first. The target of a downward run lies behind all earlier targets and before the next
/// run.
void moveRuns(std::span<const RowMoves::Run> runs, std::byte* column, std::size_t each) {
  const auto move = [&](const RowMoves::Run& r) {
    std::memmove(column + r.to * each, column + r.from * each, r.count * each);
  };
  for (std::size_t k = 0; k < runs.size();) {
    std::size_t up = k;
    while (up < runs.size() && runs[up].to > runs[up].from) up++;
    for (std::size_t j = up; j-- > k;) move(runs[j]);
    for (k = up; k < runs.size() && runs[k].to <= runs[k].from; k++)
      if (runs[k].to < runs[k].from) move(runs[k]);
  }
}

}  // namespace

void Table::resize(std::size_t newOwned, std::size_t newGhosts) {
  assert(newOwned == owned || ghosts == 0);  // ghosts lie behind the owned rows and would become owned
  owned = newOwned;
  ghosts = newGhosts;
  for (AnyColumn* c : columns)
    if (c->active) resizeColumn(*c, rowsOf(*c));
}

void Table::shrink(double part) {
  spares_.clear();
  for (AnyColumn* c : columns)
    if (static_cast<double>(c->bytes.capacity()) > (1 + part) * static_cast<double>(c->bytes.size()))
      c->bytes = AlignedVector<std::byte>(c->bytes.begin(), c->bytes.end());
}

void Table::activate(AnyColumn& column) {
  if (column.active) return;
  column.active = true;
  resizeColumn(column, rowsOf(column));
}

void Table::deactivate(AnyColumn& column) {
  column.active = false;
  column.bytes = {};
}

void Table::reserve(std::size_t rows) {
  for (AnyColumn* c : columns)
    if (c->active)
      c->bytes.reserve((c->rows == Rows::Owned ? std::min(owned, rows) : rows) * c->elementBytes);
}

void Table::reorder(std::span<const std::uint32_t> order, std::span<AnyColumn* const> stale) {
  for (AnyColumn* c : columns) {
    if (!c->active) continue;
    if (c->keep != Keep::Transient && !contains(stale, c)) {
      const std::size_t need = order.size() * c->elementBytes;
      // Only columns of the same width share a buffer; otherwise each buffer would grow to the widest column.
      auto at = std::find_if(spares_.begin(), spares_.end(),
                             [&](const auto& s) { return s.first == c->elementBytes; });
      if (at == spares_.end()) at = spares_.insert(at, {c->elementBytes, {}});
      AlignedVector<std::byte>& spare = at->second;
      makeRoom(spare, order.size(), c->elementBytes);
      spare.resize(need);
      switch (c->elementBytes) {
        case 24: gather<Three>(c->bytes.data(), spare.data(), order); break;
        case 8: gather<std::uint64_t>(c->bytes.data(), spare.data(), order); break;
        case 4: gather<std::uint32_t>(c->bytes.data(), spare.data(), order); break;
        case 2: gather<std::uint16_t>(c->bytes.data(), spare.data(), order); break;
        case 1: gather<std::uint8_t>(c->bytes.data(), spare.data(), order); break;
        default:
          for (std::size_t i = 0; i < order.size(); i++)
            std::memcpy(spare.data() + i * c->elementBytes, c->bytes.data() + order[i] * c->elementBytes,
                        c->elementBytes);
      }
      c->bytes.swap(spare);
    } else {
      resizeColumn(*c, order.size());
    }
  }
  owned = order.size();
  ghosts = 0;
}

void Table::rearrange(const RowMoves& moves, std::span<AnyColumn* const> stale) {
  assert(ghosts == 0);
  spares_.clear();
  for (AnyColumn* c : columns) {
    if (!c->active || c->keep == Keep::Transient || contains(stale, c)) continue;
    const std::size_t each = c->elementBytes;
    std::byte* const rows = c->bytes.data();
    singles_.resize(std::max(singles_.size(), moves.singles.size() * each));
    for (std::size_t k = 0; k < moves.singles.size(); k++)
      std::memcpy(singles_.data() + k * each, rows + moves.singles[k].from * each, each);
    moveRuns(moves.runs, rows, each);
    for (std::size_t k = 0; k < moves.singles.size(); k++)
      std::memcpy(rows + moves.singles[k].to * each, singles_.data() + k * each, each);
  }
  resize(moves.rows, 0);
}

std::size_t Table::bufferBytes() const {
  std::size_t n = singles_.capacity();
  for (const auto& s : spares_) n += s.second.capacity();
  return n;
}

AnyColumn* Table::find(const char* name) {
  for (AnyColumn* c : columns)
    if (std::strcmp(c->name, name) == 0) return c;
  return nullptr;
}

std::size_t Table::stateBytes() const {
  std::size_t bytes = 0;
  for (const AnyColumn* c : columns)
    if (c->active && c->keep == Keep::State) bytes += c->elementBytes;
  return bytes;
}

void Table::packState(std::size_t row, std::byte* to) const {
  for (const AnyColumn* c : columns)
    if (c->active && c->keep == Keep::State) {
      std::memcpy(to, c->bytes.data() + row * c->elementBytes, c->elementBytes);
      to += c->elementBytes;
    }
}

void Table::unpackState(std::size_t row, const std::byte* from) {
  for (AnyColumn* c : columns)
    if (c->active && c->keep == Keep::State) {
      std::memcpy(c->bytes.data() + row * c->elementBytes, from, c->elementBytes);
      from += c->elementBytes;
    }
}

}  // namespace thaw
