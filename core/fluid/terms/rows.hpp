// SPDX-License-Identifier: Apache-2.0
// Reads and writes columns at the rows of eight lanes.
#pragma once
#include "core/fluid/terms/lane_vectors.hpp"
#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

THAW_INLINE void setLane(LanesF& v, int l, double x) { v.v[l] = static_cast<float>(x); }
THAW_INLINE void setLane(LanesD& v, int l, double x) { l < 4 ? v.lo[l] = x : v.hi[l - 4] = x; }
THAW_INLINE LanesF narrowed(LanesD a, LanesF) {
  typedef float Half __attribute__((vector_size(16)));
  const Half lo = __builtin_convertvector(a.lo, Half), hi = __builtin_convertvector(a.hi, Half);
  return LanesF(__builtin_shufflevector(lo, hi, 0, 1, 2, 3, 4, 5, 6, 7));
}
THAW_INLINE LanesD narrowed(LanesD a, LanesD) { return a; }
THAW_INLINE LanesF toFloats(LanesF a) { return a; }
THAW_INLINE LanesF toFloats(LanesD a) { return narrowed(a, LanesF(0.0f)); }

/// The rows of a group. Lanes from `count` on hold no particle; their rows are valid.
struct GroupRows {
  const std::uint32_t* row;
  int count;
  bool consecutive;  ///< eight rows in a row, so that columns are read and written as vectors

  template<class T> THAW_INLINE LanesD doubles(const T* column) const {
    LanesD v;
    for (int l = 0; l < 8; l++) setLane(v, l, static_cast<double>(column[row[l]]));
    return v;
  }
  THAW_INLINE LanesD doubles(const double* column) const {
    LanesD v;
    if (consecutive) {
      __builtin_memcpy(&v.lo, column + row[0], sizeof v.lo);
      __builtin_memcpy(&v.hi, column + row[0] + 4, sizeof v.hi);
    } else {
      for (int l = 0; l < 8; l++) setLane(v, l, column[row[l]]);
    }
    return v;
  }
};

THAW_INLINE GroupRows groupRows(const std::uint32_t* rows, int count) {
  bool consecutive = count == 8;
  for (int l = 1; l < 8; l++) consecutive &= rows[l] == rows[0] + static_cast<std::uint32_t>(l);
  return {rows, count, consecutive};
}

/// Lanes that are written, as bits.
using LaneBits = unsigned;

THAW_INLINE void write(const GroupRows& r, LaneBits lanes, LanesD v, double* column) {
  if (r.consecutive && lanes == 0xff) {
    __builtin_memcpy(column + r.row[0], &v.lo, sizeof v.lo);
    __builtin_memcpy(column + r.row[0] + 4, &v.hi, sizeof v.hi);
  } else {
    for (int l = 0; l < r.count; l++)
      if (lanes >> l & 1) column[r.row[l]] = v[l];
  }
}
THAW_INLINE void write(const GroupRows& r, LaneBits lanes, LanesF v, float* column) {
  if (r.consecutive && lanes == 0xff) {
    __builtin_memcpy(column + r.row[0], &v.v, sizeof v.v);
  } else {
    for (int l = 0; l < r.count; l++)
      if (lanes >> l & 1) column[r.row[l]] = v[l];
  }
}

typedef float Two __attribute__((vector_size(8)));

/// Four values of each lane, lanes l and l + 4 in the halves of the vector l.
THAW_INLINE void byLane(LanesF a, LanesF b, LanesF c, LanesF d, Vec8f (&to)[4]) {
  const Vec8f ab0 = unpackLow(a.v, b.v), ab2 = unpackHigh(a.v, b.v), cd0 = unpackLow(c.v, d.v),
              cd2 = unpackHigh(c.v, d.v);
  to[0] = __builtin_shufflevector(ab0, cd0, 0, 1, 8, 9, 4, 5, 12, 13);
  to[1] = __builtin_shufflevector(ab0, cd0, 2, 3, 10, 11, 6, 7, 14, 15);
  to[2] = __builtin_shufflevector(ab2, cd2, 0, 1, 8, 9, 4, 5, 12, 13);
  to[3] = __builtin_shufflevector(ab2, cd2, 2, 3, 10, 11, 6, 7, 14, 15);
}
THAW_INLINE Vec4f laneOf(const Vec8f (&byLane)[4], int l) {
  return l < 4 ? __builtin_shufflevector(byLane[l & 3], byLane[l & 3], 0, 1, 2, 3)
               : __builtin_shufflevector(byLane[l & 3], byLane[l & 3], 4, 5, 6, 7);
}

template<class L>
THAW_INLINE void write(const GroupRows& r, LaneBits lanes, const Tensor<L>& v, Sym3f* column) {
  Vec8f first[4], last[4];
  byLane(toFloats(v.xx), toFloats(v.yy), toFloats(v.zz), toFloats(v.xy), first);
  byLane(toFloats(v.yz), toFloats(v.xz), toFloats(v.yz), toFloats(v.xz), last);
  for (int l = 0; l < 8; l++)
    if (lanes >> l & 1) {
      char* const to = reinterpret_cast<char*>(column + r.row[l]);
      const Vec4f four = laneOf(first, l), two = laneOf(last, l);
      __builtin_memcpy(to, &four, 16);
      __builtin_memcpy(to + 16, &two, 8);
    }
}

/// Reads tensors of eight rows.
template<class L> THAW_INLINE Tensor<L> tensors(const GroupRows& r, const Sym3f* column) {
  Vec4f four[8], two[8];
  for (int l = 0; l < 8; l++) {
    const char* const from = reinterpret_cast<const char*>(column + r.row[l]);
    two[l] = Vec4f{};
    __builtin_memcpy(&four[l], from, 16);
    __builtin_memcpy(&two[l], from + 16, 8);
  }
  const auto pair = [](const Vec4f& a, const Vec4f& b) {
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Vec8f f0 = pair(four[0], four[4]), f1 = pair(four[1], four[5]), f2 = pair(four[2], four[6]),
              f3 = pair(four[3], four[7]);
  const Vec8f ab01 = unpackLow(f0, f1), cd01 = unpackHigh(f0, f1), ab23 = unpackLow(f2, f3),
              cd23 = unpackHigh(f2, f3);
  const Vec8f e01 = unpackLow(pair(two[0], two[4]), pair(two[1], two[5])),
              e23 = unpackLow(pair(two[2], two[6]), pair(two[3], two[7]));
  const auto even = [](Vec8f a, Vec8f b) {
    return LanesF(__builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13));
  };
  const auto odd = [](Vec8f a, Vec8f b) {
    return LanesF(__builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15));
  };
  const auto to = [](LanesF v) {
    if constexpr (sizeof(L) == sizeof(LanesF)) return v;
    else return widen(v);
  };
  return {to(even(ab01, ab23)), to(odd(ab01, ab23)), to(even(cd01, cd23)),
          to(odd(cd01, cd23)),  to(even(e01, e23)),  to(odd(e01, e23))};
}

/// Writes vectors as doubles.
template<class L> THAW_INLINE void write(const GroupRows& r, LaneBits lanes, L x, L y, L z, Vec3d* column) {
  if constexpr (sizeof(L) == sizeof(LanesF)) {
    Vec8f v[4];
    byLane(x, y, z, z, v);
    for (int l = 0; l < 8; l++)
      if (lanes >> l & 1) {
        const Vec4d wide = __builtin_convertvector(laneOf(v, l), Vec4d);
        __builtin_memcpy(reinterpret_cast<char*>(column + r.row[l]), &wide, sizeof(Vec3d));
      }
  } else {
    for (int l = 0; l < 8; l++)
      if (lanes >> l & 1) column[r.row[l]] = {x[l], y[l], z[l]};
  }
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
