// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/monitor/packed_columns.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace thaw {
namespace {

constexpr std::size_t slack = sizeof(std::uint64_t);  // extra bytes, since whole words are stored and read
                                                      // even if only a part is used

/// Storage of the words of one component in a block. Bytes [low, low + width) of each word are stored. The
/// other bytes equal those of `common`.
struct WordShape {
  std::uint64_t common;
  std::uint8_t low, width;
};
constexpr std::size_t shapeBytes = sizeof(std::uint64_t) + 2;

template<class Word> WordShape shapeOf(const std::byte* from, std::size_t stride, std::size_t rows) {
  Word first, word, varying = 0;
  std::memcpy(&first, from, sizeof first);
  for (std::size_t r = 1; r < rows; r++) {
    std::memcpy(&word, from + r * stride, sizeof word);
    varying |= static_cast<Word>(word ^ first);
  }
  const std::uint64_t v = varying;
  if (v == 0) return {first, 0, 0};
  const int low = std::countr_zero(v) / 8, high = (std::bit_width(v) + 7) / 8;
  return {first, static_cast<std::uint8_t>(low), static_cast<std::uint8_t>(high - low)};
}

template<class Word>
void packWords(const std::byte* from, std::size_t stride, std::size_t rows, const WordShape& s,
               std::byte* to) {
  for (std::size_t r = 0; r < rows; r++, to += s.width) {  // each word overwrites the excess bytes of the
                                                           // previous word
    Word word;
    std::memcpy(&word, from + r * stride, sizeof word);
    const std::uint64_t kept = std::uint64_t{word} >> (8 * s.low);
    std::memcpy(to, &kept, sizeof kept);
  }
}

template<class Word>
void unpackWords(const std::byte* from, const WordShape& s, std::size_t rows, std::byte* to,
                 std::size_t stride) {
  const std::uint64_t mask = s.width == 0 ? 0 : ~std::uint64_t{0} >> (64 - 8 * s.width);
  const std::uint64_t rest = s.common & ~(mask << (8 * s.low));
  for (std::size_t r = 0; r < rows; r++, from += s.width, to += stride) {
    std::uint64_t kept;
    std::memcpy(&kept, from, sizeof kept);
    const Word word = static_cast<Word>(rest | (kept & mask) << (8 * s.low));
    std::memcpy(to, &word, sizeof word);
  }
}

/// Calls use(Word{}) with the unsigned type of one component.
template<class Use> auto withWord(std::size_t bytes, Use&& use) {
  if (bytes == 8) return use(std::uint64_t{});
  if (bytes == 4) return use(std::uint32_t{});
  if (bytes == 2) return use(std::uint16_t{});
  return use(std::uint8_t{});
}

template<class Word> void packColumn(const AnyColumn& c, std::size_t rows, PackedColumn& p) {
  const std::size_t components = static_cast<std::size_t>(c.components),
                    blocks = (rows + packedBlock - 1) / packedBlock;
  std::vector<WordShape> shapes;
  shapes.reserve(blocks * components);
  p.block.resize(blocks);
  std::size_t bytes = 0;
  const auto rowsOf = [&](std::size_t b) { return std::min(packedBlock, rows - b * packedBlock); };
  const auto begin = [&](std::size_t b, std::size_t k) {
    return c.bytes.data() + b * packedBlock * c.elementBytes + k * sizeof(Word);
  };
  for (std::size_t b = 0; b < blocks; b++) {
    p.block[b] = bytes;
    for (std::size_t k = 0; k < components; k++) {
      shapes.push_back(shapeOf<Word>(begin(b, k), c.elementBytes, rowsOf(b)));
      bytes += shapeBytes + shapes.back().width * rowsOf(b);
    }
  }
  if (bytes + slack > p.bytes.capacity()) {  // the old memory is freed first, so that old and new memory
                                             // never coexist
    p.bytes = {};
    p.bytes.reserve(bytes + bytes / 64 + slack);
  }
  p.bytes.resize(bytes + slack);
  std::byte* to = p.bytes.data();
  for (std::size_t b = 0; b < blocks; b++)
    for (std::size_t k = 0; k < components; k++) {
      const WordShape& s = shapes[b * components + k];
      std::memcpy(to, &s.common, sizeof s.common);
      to[8] = std::byte{s.low};
      to[9] = std::byte{s.width};
      to += shapeBytes;
      if (s.width > 0) packWords<Word>(begin(b, k), c.elementBytes, rowsOf(b), s, to);
      to += s.width * rowsOf(b);
    }
}

}  // namespace

std::size_t PackedTable::bytes() const {
  std::size_t n = 0;
  for (const PackedColumn& p : columns) n += p.bytes.capacity() + p.block.capacity() * sizeof p.block[0];
  return n;
}

void packState(const Table& table, PackedTable& packed) {
  packed.rows = table.owned;
  packed.columns.resize(table.columns.size());
  for (std::size_t c = 0; c < table.columns.size(); c++) {
    const AnyColumn& column = *table.columns[c];
    PackedColumn& p = packed.columns[c];
    p.there = column.active && column.keep == Keep::State;
    if (p.there)
      withWord(bytesOf(column.scalar),
               [&](auto word) { packColumn<decltype(word)>(column, table.owned, p); });
    else p = {};
  }
}

void unpackRows(const PackedTable& packed, const AnyColumn& like, std::size_t c, std::size_t first,
                std::size_t count, std::byte* to) {
  const PackedColumn& p = packed.columns[c];
  for (std::size_t done = 0; done < count;) {
    const std::size_t b = (first + done) / packedBlock, skip = first + done - b * packedBlock,
                      inBlock = std::min(packedBlock, packed.rows - b * packedBlock);
    const std::size_t rows = std::min(count - done, inBlock - skip);
    const std::byte* from = p.bytes.data() + p.block[b];
    withWord(bytesOf(like.scalar), [&](auto word) {
      for (int k = 0; k < like.components; k++) {
        WordShape s;
        std::memcpy(&s.common, from, sizeof s.common);
        s.low = static_cast<std::uint8_t>(from[8]);
        s.width = static_cast<std::uint8_t>(from[9]);
        from += shapeBytes;
        unpackWords<decltype(word)>(from + skip * s.width, s, rows,
                                    to + done * like.elementBytes + static_cast<std::size_t>(k) * sizeof word,
                                    like.elementBytes);
        from += inBlock * s.width;
      }
    });
    done += rows;
  }
}

void unpackState(const PackedTable& packed, Table& table) {
  table.resize(packed.rows, 0);
  for (std::size_t c = 0; c < packed.columns.size(); c++) {
    if (!packed.columns[c].there) continue;
    table.activate(*table.columns[c]);
    unpackRows(packed, *table.columns[c], c, 0, packed.rows, table.columns[c]->bytes.data());
  }
}

}  // namespace thaw
