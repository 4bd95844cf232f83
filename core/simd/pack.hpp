// SPDX-License-Identifier: Apache-2.0
// Compaction of selected words. A search writes its results without a branch per candidate.
#pragma once
#include "core/simd/lanes.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace thaw {
namespace THAW_ISA {

#if defined(__AVX2__) && !defined(__AVX512VL__)
struct PackTable {
  alignas(32) std::int32_t lane[256][8];
};
constexpr PackTable makePackTable() {
  PackTable t{};
  for (int m = 0; m < 256; m++) {
    int n = 0;
    for (int l = 0; l < 8; l++)
      if (m >> l & 1) t.lane[m][n++] = l;
  }
  return t;
}
inline constexpr PackTable packTable = makePackTable();
#endif

/// Writes the words with set bits in `kept` (below 256) to out in order, and returns their number. It
/// overwrites all of out[0 ... 7].
THAW_INLINE std::uint32_t pack8(Vec8u words, std::uint32_t kept, std::uint32_t* out) {
#if defined(__AVX512VL__)
  _mm256_storeu_si256(
      reinterpret_cast<__m256i*>(out),
      _mm256_maskz_compress_epi32(static_cast<__mmask8>(kept), reinterpret_cast<__m256i>(words)));
#elif defined(__AVX2__)
  const __m256i lane = _mm256_load_si256(reinterpret_cast<const __m256i*>(packTable.lane[kept]));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                      _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(words), lane));
#else
  for (int l = 0, n = 0; l < 8; l++) {
    out[n] = words[l];
    n += static_cast<int>(kept >> l & 1);
  }
#endif
  return static_cast<std::uint32_t>(__builtin_popcount(kept));
}

/// Returns a mask with bit l set if lane l is set.
THAW_INLINE std::uint32_t bitsOf(MaskF m) {
#if defined(__AVX__)
  return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(m.bits)));
#else
  std::uint32_t bits = 0;
  for (int l = 0; l < 8; l++) bits |= static_cast<std::uint32_t>(m.bits[l] & 1) << l;
  return bits;
#endif
}

}  // namespace THAW_ISA
}  // namespace thaw
