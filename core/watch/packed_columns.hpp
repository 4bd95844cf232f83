// Columns of a table kept in less memory, bit by bit: of each block of rows the bytes that all words of it
// share are kept once. Rows are sorted by cells, so that in a block ids and places have high bytes in common;
// mass, material and books are mostly one value throughout.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/particles/column.hpp"

namespace thaw {

struct PackedColumn {
  bool there = false;
  AlignedVector<std::byte> bytes;
  std::vector<std::size_t> block;  ///< where each block of packedBlock rows begins in `bytes`
};

constexpr std::size_t packedBlock = 1024;  // rows

/// Keep::State columns of the first `rows` rows of a table; what is not State or not active is not there.
struct PackedTable {
  std::size_t rows = 0;
  std::vector<PackedColumn> columns;  ///< as Table::columns

  std::size_t bytes() const;  ///< that it takes
};

/// Packs the owned rows. Memory of the pack before is used again where it is enough.
void packState(const Table& table, PackedTable& packed);

/// Rows [first, first + count) of column `c`, as they were, to `to`. Any rows, at the same cost each.
void unpackRows(const PackedTable& packed, const AnyColumn& like, std::size_t c, std::size_t first,
                std::size_t count, std::byte* to);

/// All of it into a table without rows that lists the same columns: it has packed.rows owned ones then.
void unpackState(const PackedTable& packed, Table& table);

}  // namespace thaw
