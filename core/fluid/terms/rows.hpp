// SPDX-License-Identifier: Apache-2.0
// Functions that read and write columns at the rows of eight lanes.
#pragma once
#include "core/fluid/terms/lane_vectors.hpp"
#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

typedef double Pair64 __attribute__((vector_size(16)));

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
  bool consecutive;  ///< the eight rows are consecutive, so that columns are read and written as vectors

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
  THAW_INLINE LanesF floats(const float* column) const {
    LanesF v;
    if (consecutive) __builtin_memcpy(&v, column + row[0], sizeof v);
    else
      for (int l = 0; l < 8; l++) setLane(v, l, static_cast<double>(column[row[l]]));
    return v;
  }
};

THAW_INLINE GroupRows groupRows(const std::uint32_t* rows, int count) {
  bool consecutive = count == 8;
  for (int l = 1; l < 8; l++) consecutive &= rows[l] == rows[0] + static_cast<std::uint32_t>(l);
  return {rows, count, consecutive};
}

/// Prefetches a column at the rows of a group, which are mostly consecutive. A null column is ignored.
template<class T> THAW_INLINE void prefetchRows(const T* column, const std::uint32_t* rows) {
  if (!column) return;
  const char* const at = reinterpret_cast<const char*>(column + rows[0]);
  constexpr std::size_t line = 64;
  for (std::size_t byte = 0; byte < 8 * sizeof(T); byte += line) __builtin_prefetch(at + byte);
}

/// Bit mask of the lanes that are written.
using LaneBits = unsigned;

template<class Real> THAW_INLINE void write(const GroupRows& r, LaneBits lanes, Lanes<Real> v, Real* column) {
  if (r.consecutive && lanes == 0xff) {
    __builtin_memcpy(column + r.row[0], &v, sizeof v);
  } else {
    for (int l = 0; l < r.count; l++)
      if (lanes >> l & 1) column[r.row[l]] = v[l];
  }
}

/// Writes 1 where v is above 0, else 0. v is 0 or 1.
THAW_INLINE void writeFlags(const GroupRows& r, LaneBits lanes, LanesF v, std::uint8_t* column) {
  if (r.consecutive && lanes == 0xff) {
    typedef std::uint8_t Bytes __attribute__((vector_size(8)));
    const Bytes flags = __builtin_convertvector(__builtin_convertvector(v.v, Vec8i), Bytes);
    __builtin_memcpy(column + r.row[0], &flags, sizeof flags);
  } else {
    for (int l = 0; l < r.count; l++)
      if (lanes >> l & 1) column[r.row[l]] = v[l] > 0;
  }
}

template<class L>
THAW_INLINE void write(const GroupRows& r, LaneBits lanes, const Tensor<L>& v, Sym3f* column) {
  Vec8f first[4], last[4];
  toRows({toFloats(v.xx), toFloats(v.yy), toFloats(v.zz), toFloats(v.xy)}, first);
  toRows({toFloats(v.yz), toFloats(v.xz), toFloats(v.yz), toFloats(v.xz)}, last);
  for (int l = 0; l < 8; l++)
    if (lanes >> l & 1) {
      char* const to = reinterpret_cast<char*>(column + r.row[l]);
      const Vec4f four = rowOf(first, l), two = rowOf(last, l);
      __builtin_memcpy(to, &four, 16);
      __builtin_memcpy(to + 16, &two, 8);
    }
}

/// Reads tensors of eight rows.
template<class L> THAW_INLINE Tensor<L> tensors(const GroupRows& r, const Sym3f* column) {
  Vec4f four[8], two[8];
  for (int l = 0; l < 8; l++) {
    const char* const from = reinterpret_cast<const char*>(column + r.row[l]);
    double last;  // a separate scalar, since half of a vector would pass through memory
    __builtin_memcpy(&four[l], from, 16);
    __builtin_memcpy(&last, from + 16, 8);
    two[l] = reinterpret_cast<Vec4f>(Pair64{last, 0});
  }
  const auto both = [](const Vec4f(&v)[8], int l) {
    return __builtin_shufflevector(v[l], v[l + 4], 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Lanes4<float> first = fromRows(both(four, 0), both(four, 1), both(four, 2), both(four, 3)),
                      last = fromRows(both(two, 0), both(two, 1), both(two, 2), both(two, 3));
  const auto to = [](LanesF v) {
    if constexpr (sizeof(L) == sizeof(LanesF)) return v;
    else return widen(v);
  };
  return {to(first.a), to(first.b), to(first.c), to(first.d), to(last.a), to(last.b)};
}

/// Writes vectors as doubles.
template<class L> THAW_INLINE void write(const GroupRows& r, LaneBits lanes, L x, L y, L z, Vec3d* column) {
  if constexpr (sizeof(L) == sizeof(LanesF)) {
    Vec8f v[4];
    toRows({x, y, z, z}, v);
    for (int l = 0; l < 8; l++)
      if (lanes >> l & 1) {
        const Vec4d wide = __builtin_convertvector(rowOf(v, l), Vec4d);
        const Pair64 first = __builtin_shufflevector(wide, wide, 0, 1);
        char* const to = reinterpret_cast<char*>(column + r.row[l]);
        __builtin_memcpy(to, &first, 16);
        const double third = wide[2];
        __builtin_memcpy(to + 16, &third, 8);
      }
  } else {
    for (int l = 0; l < 8; l++)
      if (lanes >> l & 1) column[r.row[l]] = {x[l], y[l], z[l]};
  }
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
