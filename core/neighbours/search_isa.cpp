// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set (core/fluid/pair_sums/dispatch.cpp).
#include "core/neighbours/neighbour_lists.hpp"
#include "core/neighbours/pick_direct.hpp"
#include "core/neighbours/search.hpp"
#include "core/simd/lanes.hpp"
#include "core/simd/pack.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// A row of three cells along x. Their position in the table is found by an index that only advances.
struct CellRow {
  std::uint64_t offset = 0;  // key offset, two's complement
  std::size_t at = 0;
};

/// Lists the candidates within the support radius of candidate `self`, except itself. Returns their number.
/// It writes up to 15 entries more.
std::uint32_t pick(const SearchBuffers& b, std::uint32_t candidates, std::uint32_t self, std::uint32_t* out) {
  const std::uint16_t *x = b.x.data(), *y = b.y.data(), *z = b.z.data();
  const std::uint32_t* entry = b.entry.data();
  std::uint32_t n = 0;
#if defined(__AVX512BW__)
  const __m512i X = _mm512_set1_epi16(static_cast<short>(x[self])),
                Y = _mm512_set1_epi16(static_cast<short>(y[self])),
                Z = _mm512_set1_epi16(static_cast<short>(z[self]));
  const __m512i R = _mm512_set1_epi16(reach2);
  for (std::uint32_t c = 0; c < candidates; c += 32) {
    const __m512i dx = _mm512_sub_epi16(_mm512_load_si512(x + c), X),
                  dy = _mm512_sub_epi16(_mm512_load_si512(y + c), Y),
                  dz = _mm512_sub_epi16(_mm512_load_si512(z + c), Z);
    const __m512i d2 = _mm512_add_epi16(
        _mm512_add_epi16(_mm512_mulhi_epi16(dx, dx), _mm512_mulhi_epi16(dy, dy)), _mm512_mulhi_epi16(dz, dz));
    std::uint32_t m = _mm512_cmplt_epu16_mask(d2, R);
    const std::uint32_t own = self - c, left = candidates - c;
    m &= ~(own < 32 ? 1u << (own & 31) : 0u) & (left < 32 ? (1u << (left & 31)) - 1 : ~0u);
    const __mmask16 low = static_cast<__mmask16>(m), high = static_cast<__mmask16>(m >> 16);
    _mm512_storeu_si512(out + n, _mm512_maskz_compress_epi32(low, _mm512_load_si512(entry + c)));
    n += static_cast<std::uint32_t>(__builtin_popcount(low));
    _mm512_storeu_si512(out + n, _mm512_maskz_compress_epi32(high, _mm512_load_si512(entry + c + 16)));
    n += static_cast<std::uint32_t>(__builtin_popcount(high));
  }
#elif defined(__AVX2__)
  const __m256i X = _mm256_set1_epi16(static_cast<short>(x[self])),
                Y = _mm256_set1_epi16(static_cast<short>(y[self])),
                Z = _mm256_set1_epi16(static_cast<short>(z[self]));
  const __m256i R = _mm256_set1_epi16(reach2);
  const auto at = [](const void* p) { return _mm256_load_si256(static_cast<const __m256i*>(p)); };
  for (std::uint32_t c = 0; c < candidates; c += 16) {
    const __m256i dx = _mm256_sub_epi16(at(x + c), X), dy = _mm256_sub_epi16(at(y + c), Y),
                  dz = _mm256_sub_epi16(at(z + c), Z);
    const __m256i d2 = _mm256_adds_epi16(
        _mm256_adds_epi16(_mm256_mulhi_epi16(dx, dx), _mm256_mulhi_epi16(dy, dy)),
        _mm256_mulhi_epi16(dz, dz));
    const __m256i near = _mm256_permute4x64_epi64(
        _mm256_packs_epi16(_mm256_cmpgt_epi16(R, d2), _mm256_setzero_si256()), 0xd8);
    std::uint32_t m = static_cast<std::uint32_t>(_mm256_movemask_epi8(near));
    const std::uint32_t own = self - c, left = candidates - c;
    m &= ~(own < 16 ? 1u << (own & 31) : 0u) & (left < 16 ? (1u << (left & 31)) - 1 : ~0u);
    for (std::uint32_t half = 0; half < 2; half++, m >>= 8)
      n += pack8(reinterpret_cast<Vec8u>(at(entry + c + 8 * half)), m & 255, out + n);
  }
#else
  const auto square = [](int a, int b) {
    const int d = static_cast<std::int16_t>(a - b);
    return d * d >> 16;
  };
  const int X = x[self], Y = y[self], Z = z[self];
  for (std::uint32_t c = 0; c < candidates; c++) {
    out[n] = entry[c];
    n += square(x[c], X) + square(y[c], Y) + square(z[c], Z) < reach2 && c != self;
  }
#endif
  return n;
}

/// Stores eight entries of a list. past: non-temporal stores, for lists too long to stay in the caches; they
/// avoid reading the lines first.
template<bool past> THAW_INLINE void put(std::uint32_t* to, Vec8u v) {
#if defined(__AVX__)
  if constexpr (past)
    return _mm256_stream_si256(reinterpret_cast<__m256i*>(to), reinterpret_cast<__m256i>(v));
#endif
  __builtin_memcpy(to, &v, 32);
}

/// Row r of `to` becomes column r of the eight rows in `from`.
template<bool past>
THAW_INLINE void transpose8(std::uint32_t* const from[8], std::uint32_t k, std::uint32_t* to) {
  Vec8u r[8], s[8];
  for (int l = 0; l < 8; l++) __builtin_memcpy(&r[l], from[l] + k, 32);
  for (int l = 0; l < 8; l += 2) {  // pairs of rows
    s[l] = __builtin_shufflevector(r[l], r[l + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    s[l + 1] = __builtin_shufflevector(r[l], r[l + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int l = 0; l < 8; l += 4) {  // fours
    r[l] = __builtin_shufflevector(s[l], s[l + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    r[l + 1] = __builtin_shufflevector(s[l], s[l + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    r[l + 2] = __builtin_shufflevector(s[l + 1], s[l + 3], 0, 1, 8, 9, 4, 5, 12, 13);
    r[l + 3] = __builtin_shufflevector(s[l + 1], s[l + 3], 2, 3, 10, 11, 6, 7, 14, 15);
  }
  for (int l = 0; l < 4; l++) {
    const Vec8u low = __builtin_shufflevector(r[l], r[l + 4], 0, 1, 2, 3, 8, 9, 10, 11),
                high = __builtin_shufflevector(r[l], r[l + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    put<past>(to + 8 * l, low);
    put<past>(to + 8 * (l + 4), high);
  }
}

constexpr std::size_t beyondCaches = std::size_t(64) << 20;  // bytes

/// Interleaves these lists of the window into a group of lists.list. It writes up to seven rows of eight
/// entries beyond the group.
void closeGroup(SearchBuffers& b, const std::uint32_t* which, int filled, NeighbourLists& lists) {
  std::uint32_t most = 0;
  for (int l = 0; l < filled; l++) most = most < b.length[which[l]] ? b.length[which[l]] : most;
  const std::size_t g = lists.groups;
  const std::uint64_t first = g == 0 ? 0 : lists.first[g - 1] + 8ull * lists.count[g - 1];
  const std::uint32_t room = (most + 7) / 8 * 8;
  if (lists.list.size() < first + 8ull * room) growList(lists, first + 8ull * room);
  std::uint32_t* to = lists.list.data() + first;
  const std::uint32_t d = 2 * lists.dummy;
  const Vec8u padding = {d, d, d, d, d, d, d, d};
  std::uint32_t* from[8];
  std::uint8_t fluid = 0;
  for (int l = 0; l < 8; l++) {
    const std::uint32_t k = which[l < filled ? l : 0];
    fluid |= b.fluid[k];
    lists.self[8 * g + static_cast<std::size_t>(l)] = l < filled ? b.self[k] : lists.dummy;
    from[l] = b.found[k].data();
    for (std::uint32_t n = b.length[k]; n < room; n += 8) __builtin_memcpy(from[l] + n, &padding, 32);
  }
  if (lists.list.size() * sizeof(lists.list[0]) > beyondCaches)
    for (std::uint32_t k = 0; k < room; k += 8) transpose8<true>(from, k, to + 8ull * k);
  else
    for (std::uint32_t k = 0; k < room; k += 8) {
      for (std::uint32_t line = 0; line < 64; line += 16)
        __builtin_prefetch(to + 8ull * k + listAhead + line, 1);
      transpose8<false>(from, k, to + 8ull * k);
    }
  for (int l = filled; l < 8; l++)
    for (std::uint32_t k = 0; k < most; k++) to[8ull * k + static_cast<std::uint32_t>(l)] = d;
  lists.first[g] = first;
  lists.count[g] = most;
  lists.fluid[g] = fluid;
  lists.groups++;
}

/// Groups the lists in the window, lists with liquid first, then by similar length. Grouping does not affect
/// sums.
void closeWindow(SearchBuffers& b, NeighbourLists& lists) {
  constexpr int n = SearchBuffers::window;
  alignas(32) std::int32_t key[n], rank[n];
  for (int k = 0; k < n; k++)  // keys are unique, since they contain the number of the list
    key[k] = k < b.filled
                 ? (b.fluid[k] ? 1 << 30 : 0) |
                       static_cast<std::int32_t>(b.length[k] < 0x3fffff ? b.length[k] : 0x3fffff) << 8 | k
                 : -1 - k;
  for (int k = 0; k < n; k += 8) {  // the rank is the number of greater keys: no branch depends on lengths
    Vec8i mine, place{};
    __builtin_memcpy(&mine, key + k, 32);
    for (int j = 0; j < n; j++) place -= key[j] > mine;
    __builtin_memcpy(rank + k, &place, 32);
  }
  std::uint32_t sorted[n];
  for (int k = 0; k < n; k++) sorted[rank[k]] = static_cast<std::uint32_t>(k);
  for (int k = 0; k < b.filled; k += 8) closeGroup(b, sorted + k, b.filled - k < 8 ? b.filled - k : 8, lists);
  b.filled = 0;
}

/// Appends the rows of a round to the candidates. It reads and writes up to 31 further entries, which later
/// candidates overwrite.
THAW_INLINE std::uint32_t addCandidates(const SearchInput& in, const SearchRound& round, SearchBuffers& b,
                                        std::uint32_t candidates) {
  for (std::uint32_t k = 0; k < round.count; k += 16) {
    __builtin_memcpy(b.x.data() + candidates + k, in.x + round.first + k, 32);
    __builtin_memcpy(b.y.data() + candidates + k, in.y + round.first + k, 32);
    __builtin_memcpy(b.z.data() + candidates + k, in.z + round.first + k, 32);
    const Vec8u entries = Vec8u{0, 2, 4, 6, 8, 10, 12, 14} + (round.entry + 2 * k), more = entries + 16;
    __builtin_memcpy(b.entry.data() + candidates + k, &entries, 32);
    __builtin_memcpy(b.entry.data() + candidates + k + 8, &more, 32);
  }
  return candidates + round.count;
}

/// Rows in the 27 cells around a cell, held as rounds in the buffers, and the position of the cell's own
/// particles among them.
struct Surroundings {
  std::uint32_t rounds, candidates;
  std::uint32_t ownRound, ownPlace, ownStart;  ///< round where the run with the cell's own rows begins;
                                               ///< index of its first particle in that run, and among all
                                               ///< candidates
  std::uint8_t fluid;
};
/// Adds a run of consecutive rows.
THAW_INLINE void addRun(SearchBuffers& b, Surroundings& s, std::uint32_t first, std::uint32_t count) {
  s.candidates += count;
  for (; count > 32; first += 32, count -= 32) {
    b.rounds[s.rounds++] = {first, 32, 2 * first, ~0u};
    if (s.rounds + 1 >= b.rounds.size()) growRounds(b);
  }
  b.rounds[s.rounds++] = {first, count, 2 * first, ~0u >> (32 - count)};
  if (s.rounds + 1 >= b.rounds.size()) growRounds(b);
}
THAW_INLINE Surroundings findSurroundings(const SearchInput& in, std::size_t c, CellRow (&rows)[9],
                                          SearchBuffers& b) {
  const std::uint64_t* const keys = in.cells->key.data();
  const std::uint32_t *const first = in.cells->first.data(), *const count = in.cells->count.data();
  const std::size_t n = in.cells->key.size();
  const std::uint64_t key = keys[c];
  Surroundings s{};
  s.fluid = in.liquid == nullptr;
  const auto ownIsIn = [&](std::size_t d) {  // called before the run that starts with cell d is added
    s.ownRound = s.rounds;
    s.ownPlace = first[c] - first[d];
    s.ownStart = s.candidates + s.ownPlace;
  };
  for (CellRow& r : rows) {
    const std::uint64_t low = key + r.offset - 1;  // keys count from 1 along each axis, so this is never
                                                   // below zero
    std::size_t d = r.at;
    while (d < n && keys[d] < low) d++;
    r.at = d;
    // The common case: three cells in a row.
    if (d + 2 < n && keys[d + 2] == low + 2 && first[d] + count[d] == first[d + 1] &&
        first[d + 1] + count[d + 1] == first[d + 2]) {
      if (d + 1 == c) ownIsIn(d);
      if (in.liquid != nullptr) s.fluid |= in.liquid[d] | in.liquid[d + 1] | in.liquid[d + 2];
      addRun(b, s, first[d], first[d + 2] + count[d + 2] - first[d]);
      continue;
    }
    for (; d < n && keys[d] <= low + 2; d++) {
      if (d == c) ownIsIn(d);
      if (in.liquid != nullptr) s.fluid |= in.liquid[d];
      if (count[d] > 0) addRun(b, s, first[d], count[d]);
    }
  }
  return s;
}

}  // namespace

void searchNeighbours(const SearchInput& in, Part part, SearchBuffers& b, NeighbourLists& lists) {
  const CellTable& cells = *in.cells;
  CellRow rows[9];
  for (int k = 0; k < 9; k++)
    rows[k].offset = static_cast<std::uint64_t>(static_cast<std::int64_t>(k / 3 - 1) * (1ll << 42) +
                                                static_cast<std::int64_t>(k % 3 - 1) * (1ll << 21));
  const std::size_t n = cells.key.size();
  b.filled = 0;
  if (b.rounds.empty()) growRounds(b);
  const bool canPickDirect = hasPickDirect();
  for (std::size_t c = 0; c < n; c++) {
    if (cells.first[c] >= in.owned || in.inner[c] == skippedCell ||
        (in.inner[c] != 0) != (part == Part::Inner))
      continue;
    const Surroundings around = findSurroundings(in, c, rows, b);
    if (b.entry.size() < around.candidates + 32) growSearch(b, around.candidates + 32);
    // If there are many short rounds, it is faster to copy the candidates first.
    const bool direct = canPickDirect && around.rounds <= around.candidates / 32 + 6;
    if (!direct) {
      std::uint32_t candidates = 0;
      for (std::uint32_t k = 0; k < around.rounds; k++)
        candidates = addCandidates(in, b.rounds[k], b, candidates);
    }
    for (std::uint32_t k = 0; k < cells.count[c]; k++) {
      const std::uint32_t row = cells.first[c] + k;
      std::uint32_t* const found = b.found[b.filled].data();
      std::uint32_t m;
      if (direct) {
        std::uint32_t& keep = b.rounds[around.ownRound + (around.ownPlace + k) / 32].keep;
        const std::uint32_t self = 1u << ((around.ownPlace + k) & 31);
        keep &= ~self;
        m = pickDirect(in, b.rounds.data(), around.rounds, row, found);
        keep |= self;
      } else {
        m = pick(b, around.candidates, around.ownStart + k, found);
      }
      b.length[b.filled] = m;
      b.self[b.filled] = row;
      b.fluid[b.filled] = around.fluid;
      lists.neighbours[row] = static_cast<std::uint16_t>(m < 65535 ? m : 65535);
      if (++b.filled == SearchBuffers::window) closeWindow(b, lists);
    }
  }
  if (b.filled > 0) closeWindow(b, lists);
  if (part == Part::Inner) lists.innerGroups = lists.groups;
}

}  // namespace THAW_ISA
}  // namespace thaw
