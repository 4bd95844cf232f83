// SPDX-License-Identifier: Apache-2.0
// Lossless compression of columns. For each block of rows, bytes common to all words are stored once. Rows
// are sorted by cell, so ids and positions of a block share high bytes. Mass, material and ledger columns are
// mostly constant.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/fields/column.hpp"

namespace thaw {

struct PackedColumn {
  bool there = false;
  AlignedVector<std::byte> bytes;
  std::vector<std::size_t> block;  ///< offset in `bytes` of each block of packedBlock rows
};

constexpr std::size_t packedBlock = 1024;  // rows

/// Keep::State columns of the first `rows` rows of a table. Other columns and inactive columns are omitted.
struct PackedTable {
  std::size_t rows = 0;
  std::vector<PackedColumn> columns;  ///< in the order of Table::columns

  std::size_t bytes() const;  ///< memory used
};

/// Packs the owned rows. Memory of the previous pack is reused if it suffices.
void packState(const Table& table, PackedTable& packed);

/// Unpacks rows [first, first + count) of column `c` to `to`. Random access has no extra cost.
void unpackRows(const PackedTable& packed, const AnyColumn& like, std::size_t c, std::size_t first,
                std::size_t count, std::byte* to);

/// Unpacks everything into an empty table that lists the same columns. The table then has packed.rows owned
/// rows.
void unpackState(const PackedTable& packed, Table& table);

}  // namespace thaw
