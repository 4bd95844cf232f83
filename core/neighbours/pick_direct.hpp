// SPDX-License-Identifier: Apache-2.0
// Neighbours of one particle, found directly in the surrounding rows without copying candidates. It needs
// AVX2, or AVX-512 with VBMI2 (Ice Lake, Zen 4 and later). Only code for one instruction set includes this.
#pragma once
#include <array>

#include "core/neighbours/search.hpp"
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Bound of the squared coarse distance, summed over the axes without the low 16 bits. Lower values are
/// within the support radius h, or at most 0.0006 h beyond it, where kernels are zero.
constexpr int reach2 = 4097;

#if defined(__AVX512BW__)
inline bool hasPickDirect() { return __builtin_cpu_supports("avx512vbmi2"); }

/// Lists the entries of the rounds' rows whose keep bit is set and that are within the support radius of row
/// `self`. Returns their number. It reads and writes up to 31 entries more. Hits are packed as bytes (twice
/// the index in the round), so a round takes one store instead of two. Masks and entries are loaded from
/// memory to relieve the port that packing uses.
__attribute__((target("avx512vbmi2"))) std::uint32_t pickDirect(const SearchInput& in,
                                                                const SearchRound* rounds,
                                                                std::uint32_t count, std::uint32_t self,
                                                                std::uint32_t* out) {
  const std::uint16_t *const x = in.x, *const y = in.y, *const z = in.z;
  const __m512i X = _mm512_set1_epi16(static_cast<short>(x[self])),
                Y = _mm512_set1_epi16(static_cast<short>(y[self])),
                Z = _mm512_set1_epi16(static_cast<short>(z[self]));
  const __m512i R = _mm512_set1_epi16(reach2);
  const __m256i places = _mm256_setr_epi8(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 34,
                                          36, 38, 40, 42, 44, 46, 48, 50, 52, 54, 56, 58, 60, 62);
  std::uint32_t* const start = out;
  for (const SearchRound* r = rounds; r < rounds + count; r++) {
    const std::size_t at = r->first;
    const __m512i dx = _mm512_sub_epi16(_mm512_loadu_si512(x + at), X),
                  dy = _mm512_sub_epi16(_mm512_loadu_si512(y + at), Y),
                  dz = _mm512_sub_epi16(_mm512_loadu_si512(z + at), Z);
    const __m512i d2 = _mm512_add_epi16(
        _mm512_add_epi16(_mm512_mulhi_epi16(dx, dx), _mm512_mulhi_epi16(dy, dy)), _mm512_mulhi_epi16(dz, dz));
    const __mmask32 near = _mm512_mask_cmplt_epu16_mask(_load_mask32(const_cast<std::uint32_t*>(&r->keep)),
                                                        d2, R);
    const __m256i packed = _mm256_maskz_compress_epi8(near, places);
    __m512i entry;
    asm("vpbroadcastd %1, %0" : "=v"(entry) : "m"(r->entry));
    _mm512_storeu_si512(out, _mm512_add_epi32(entry, _mm512_cvtepu8_epi32(_mm256_castsi256_si128(packed))));
    const int found = __builtin_popcount(near);
    if (found > 16)
      _mm512_storeu_si512(out + 16,
                          _mm512_add_epi32(entry, _mm512_cvtepu8_epi32(_mm256_extracti128_si256(packed, 1))));
    out += found;
  }
  return static_cast<std::uint32_t>(out - start);
}
#elif defined(__AVX2__)
inline bool hasPickDirect() { return true; }

/// Table of twice the indices of set bits, packed as bytes: a quarter of the memory of 32-bit indices.
constexpr std::array<std::uint64_t, 256> makePlaces() {
  std::array<std::uint64_t, 256> places{};
  for (std::uint64_t m = 0; m < 256; m++)
    for (std::uint64_t l = 0, n = 0; l < 8; l++)
      if (m >> l & 1) places[m] |= 2 * l << 8 * n++;
  return places;
}
inline constexpr std::array<std::uint64_t, 256> packedPlaces = makePlaces();

/// Packs the neighbours like the AVX-512 version. The address of each store of eight is computed from the
/// start of the round, so stores do not depend on each other.
std::uint32_t pickDirect(const SearchInput& in, const SearchRound* rounds, std::uint32_t count,
                         std::uint32_t self, std::uint32_t* out) {
  const std::uint16_t *const x = in.x, *const y = in.y, *const z = in.z;
  const __m256i X = _mm256_set1_epi16(static_cast<short>(x[self])),
                Y = _mm256_set1_epi16(static_cast<short>(y[self])),
                Z = _mm256_set1_epi16(static_cast<short>(z[self]));
  const __m256i R = _mm256_set1_epi16(reach2);
  const __m256i sixteen = _mm256_set1_epi32(16), thirtyTwo = _mm256_set1_epi32(32),
                fortyEight = _mm256_set1_epi32(48);
  const auto near = [&](std::size_t at) {
    const auto difference = [at](const std::uint16_t* from, __m256i mine) {
      return _mm256_sub_epi16(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from + at)), mine);
    };
    const __m256i dx = difference(x, X), dy = difference(y, Y), dz = difference(z, Z);
    return _mm256_cmpgt_epi16(
        R, _mm256_adds_epi16(_mm256_adds_epi16(_mm256_mulhi_epi16(dx, dx), _mm256_mulhi_epi16(dy, dy)),
                             _mm256_mulhi_epi16(dz, dz)));
  };
  std::uint32_t* const start = out;
  for (const SearchRound* r = rounds; r < rounds + count; r++) {
    const __m256i both = _mm256_permute4x64_epi64(_mm256_packs_epi16(near(r->first), near(r->first + 16)),
                                                  0xd8);
    const std::uint32_t m = static_cast<std::uint32_t>(_mm256_movemask_epi8(both)) & r->keep;
    const auto put = [](std::uint32_t* to, std::uint32_t eight, __m256i entry) {
      const __m128i places = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&packedPlaces[eight]));
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                          _mm256_add_epi32(entry, _mm256_cvtepu8_epi32(places)));
    };
    const __m256i entry = _mm256_set1_epi32(static_cast<int>(r->entry));
    put(out, m & 255, entry);
    put(out + __builtin_popcount(m & 0xff), m >> 8 & 255, _mm256_add_epi32(entry, sixteen));
    put(out + __builtin_popcount(m & 0xffff), m >> 16 & 255, _mm256_add_epi32(entry, thirtyTwo));
    put(out + __builtin_popcount(m & 0xffffff), m >> 24, _mm256_add_epi32(entry, fortyEight));
    out += __builtin_popcount(m);
  }
  return static_cast<std::uint32_t>(out - start);
}
#else
inline bool hasPickDirect() { return false; }
inline std::uint32_t pickDirect(const SearchInput&, const SearchRound*, std::uint32_t, std::uint32_t,
                                std::uint32_t*) {
  return 0;
}
#endif

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
