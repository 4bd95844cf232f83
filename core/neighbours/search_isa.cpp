// Compiled once for each instruction set (see core/simd/dispatch.hpp).
#include "core/simd/lanes.hpp"
#include "core/simd/pair_kernels.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace thaw {
namespace THAW_ISA {
namespace {

/// A row of cells along x around a cell: the three keys from `low` on, found by a pointer that only moves forward.
struct CellRow {
  std::uint64_t offset = 0;  // of key, two's complement
  std::size_t at = 0;
};

constexpr float reach2 = 1.0f + 1e-5f;  // a little beyond the support: kernels are zero there

#if defined(__AVX2__) && !(defined(__AVX512VL__) && defined(__AVX512F__))
struct CompressTable {
  alignas(32) std::int32_t lane[256][8];
};
constexpr CompressTable makeCompressTable() {
  CompressTable t{};
  for (int m = 0; m < 256; m++) {
    int n = 0;
    for (int l = 0; l < 8; l++)
      if (m >> l & 1) t.lane[m][n++] = l;
  }
  return t;
}
constexpr CompressTable compressTable = makeCompressTable();
#endif

/// Appends the candidates within the support radius of (x, y, z), but not candidate `self`; returns how many.
std::uint32_t pick(const SearchBuffers& b, std::uint32_t candidates, std::uint32_t self, std::uint32_t* out) {
  const float px = b.x[self], py = b.y[self], pz = b.z[self];
  const std::uint32_t own = b.row[self];
  std::uint32_t n = 0;
#if defined(__AVX2__)
  const __m256 X = _mm256_set1_ps(px), Y = _mm256_set1_ps(py), Z = _mm256_set1_ps(pz), R = _mm256_set1_ps(reach2);
  const __m256i O = _mm256_set1_epi32(static_cast<int>(own));
  for (std::uint32_t c = 0; c < candidates; c += 8) {
    const __m256 dx = _mm256_sub_ps(_mm256_load_ps(&b.x[c]), X), dy = _mm256_sub_ps(_mm256_load_ps(&b.y[c]), Y), dz = _mm256_sub_ps(_mm256_load_ps(&b.z[c]), Z);
    const __m256 d2 = _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy)), _mm256_mul_ps(dz, dz));
    const __m256i rows = _mm256_load_si256(reinterpret_cast<const __m256i*>(&b.row[c]));
#if defined(__AVX512VL__) && defined(__AVX512F__)
    const __mmask8 m = static_cast<__mmask8>(_mm256_cmp_ps_mask(d2, R, _CMP_LT_OQ) & _mm256_cmpneq_epi32_mask(rows, O));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + n), _mm256_maskz_compress_epi32(m, rows));
    n += static_cast<std::uint32_t>(__builtin_popcount(m));
#else
    const __m256 near = _mm256_andnot_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(rows, O)), _mm256_cmp_ps(d2, R, _CMP_LT_OQ));
    const int m = _mm256_movemask_ps(near);
    const __m256i lane = _mm256_load_si256(reinterpret_cast<const __m256i*>(compressTable.lane[m]));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + n), _mm256_permutevar8x32_epi32(rows, lane));
    n += static_cast<std::uint32_t>(__builtin_popcount(static_cast<unsigned>(m)));
#endif
  }
#else
  for (std::uint32_t c = 0; c < candidates; c++) {
    const float dx = b.x[c] - px, dy = b.y[c] - py, dz = b.z[c] - pz;
    out[n] = b.row[c];
    n += dx * dx + dy * dy + dz * dz < reach2 && b.row[c] != own;
  }
#endif
  return n;
}

/// Interleaves the eight lists of a group into lists.list.
void closeGroup(SearchBuffers& b, NeighbourLists& lists) {
  std::uint32_t longest = 0;
  for (int l = 0; l < 8; l++) {
    if (l >= b.filled) {
      b.length[l] = 0;
      b.self[l] = lists.dummy;
    }
    longest = longest < b.length[l] ? b.length[l] : longest;
  }
  const std::size_t g = lists.groups;
  const std::uint64_t first = g == 0 ? 0 : lists.first[g - 1] + 8ull * lists.count[g - 1];
  if (lists.list.size() < first + 8ull * longest) growList(lists, first + 8ull * longest);
  std::uint32_t* to = lists.list.data() + first;
  for (int l = 0; l < 8; l++) {
    const std::uint32_t* from = b.found[l].data();
    const std::uint32_t n = b.length[l];
    for (std::uint32_t k = 0; k < n; k++) to[8 * k + static_cast<std::uint32_t>(l)] = from[k];
    for (std::uint32_t k = n; k < longest; k++) to[8 * k + static_cast<std::uint32_t>(l)] = lists.dummy;
    lists.self[8 * g + static_cast<std::size_t>(l)] = b.self[l];
  }
  lists.first[g] = first;
  lists.count[g] = longest;
  lists.wet[g] = b.wet;
  lists.groups++;
  b.filled = 0;
  b.wet = 0;
}

/// Copies the particles of a cell behind the candidates, as offsets from `origin`. Eight at a time: reads and writes up to seven
/// records too many, which the next cell or the sentinels overwrite.
THAW_INLINE std::uint32_t addCandidates(const SearchInput& in, std::size_t cell, const Lanes4<float>& origin, SearchBuffers& b, std::uint32_t candidates) {
  const std::uint32_t first = in.cells->first[cell], count = in.cells->count[cell];
  if (b.row.size() < candidates + count + 16) growSearch(b, candidates + count + 16);
  const Record<float>* place = reinterpret_cast<const Record<float>*>(in.place);
  float* x = b.x.data() + candidates;
  float* y = b.y.data() + candidates;
  float* z = b.z.data() + candidates;
  std::uint32_t* row = b.row.data() + candidates;
  for (std::uint32_t k = 0; k < count; k += 8) {
    Vec8u rows;
    for (int l = 0; l < 8; l++) rows[l] = first + k + static_cast<std::uint32_t>(l);
    const std::uint32_t at[8] = {rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7]};
    const Lanes4<float> p = load(place, at);
    const Vec8f dx = positionDifference(p.a, origin.a).v, dy = positionDifference(p.b, origin.b).v, dz = positionDifference(p.c, origin.c).v;
    __builtin_memcpy(x + k, &dx, 32);
    __builtin_memcpy(y + k, &dy, 32);
    __builtin_memcpy(z + k, &dz, 32);
    __builtin_memcpy(row + k, &rows, 32);
  }
  return candidates + count;
}

}  // namespace

void searchNeighbours(const SearchInput& in, Part part, SearchBuffers& b, NeighbourLists& lists) {
  const CellTable& cells = *in.cells;
  CellRow rows[9];
  for (int k = 0; k < 9; k++)
    rows[k].offset = static_cast<std::uint64_t>(static_cast<std::int64_t>(k / 3 - 1) * (1ll << 42) + static_cast<std::int64_t>(k % 3 - 1) * (1ll << 21));
  const std::size_t n = cells.key.size();
  b.filled = 0;
  b.wet = 0;
  for (std::size_t c = 0; c < n; c++) {
    if (cells.first[c] >= in.owned || in.inner[c] == skippedCell || (in.inner[c] != 0) != (part == Part::Inner)) continue;
    const std::uint64_t key = cells.key[c];
    std::uint32_t same[8];
    for (std::uint32_t& r : same) r = cells.first[c];
    const Lanes4<float> origin = load(reinterpret_cast<const Record<float>*>(in.place), same);
    std::uint32_t candidates = 0, ownStart = 0;
    std::uint8_t wet = in.liquid == nullptr;
    for (CellRow& r : rows) {
      const std::uint64_t low = key + r.offset - 1;  // keys count from 1 on along each axis: never below zero
      while (r.at < n && cells.key[r.at] < low) r.at++;
      for (std::size_t d = r.at; d < n && cells.key[d] <= low + 2; d++) {
        if (d == c) ownStart = candidates;
        if (in.liquid != nullptr) wet |= in.liquid[d];
        candidates = addCandidates(in, d, origin, b, candidates);
      }
    }
    for (std::uint32_t k = candidates; k < candidates + 8; k++) {  // out of reach: the last vector may run over the end
      b.x[k] = b.y[k] = b.z[k] = 1e6f;
      b.row[k] = lists.dummy;
    }
    for (std::uint32_t k = 0; k < cells.count[c]; k++) {
      const std::uint32_t row = cells.first[c] + k;
      const std::uint32_t m = pick(b, candidates, ownStart + k, b.found[b.filled].data());
      b.length[b.filled] = m;
      b.self[b.filled] = row;
      b.wet |= wet;
      lists.neighbours[row] = static_cast<std::uint16_t>(m < 65535 ? m : 65535);
      if (++b.filled == 8) closeGroup(b, lists);
    }
  }
  if (b.filled > 0) closeGroup(b, lists);
  if (part == Part::Inner) lists.innerGroups = lists.groups;
}

}  // namespace THAW_ISA
}  // namespace thaw
