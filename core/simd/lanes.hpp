// SPDX-License-Identifier: Apache-2.0
// Vectors of eight lanes: Lanes<float> is one 256-bit vector, Lanes<double> two. GCC vector extensions
// compile for AVX-512, AVX2 and SSE2 with the same bits: only IEEE operations, no contraction, no reciprocal
// approximations. This file is compiled once per instruction set. Each copy has its own namespace, so the
// linker does not mix copies.
#pragma once
#include <cstddef>
#include <cstdint>

#ifndef THAW_ISA
#define THAW_ISA isa_base
#endif
#ifdef THAW_SANITIZE  // inlined kernels with checks compile very slowly
#define THAW_INLINE inline
#else
#define THAW_INLINE inline __attribute__((always_inline))
#endif

namespace thaw {
namespace THAW_ISA {

typedef float Vec8f __attribute__((vector_size(32)));
typedef std::int32_t Vec8i __attribute__((vector_size(32)));
typedef std::uint32_t Vec8u __attribute__((vector_size(32)));
typedef double Vec4d __attribute__((vector_size(32)));
typedef std::int64_t Vec4l __attribute__((vector_size(32)));
typedef float Vec4f __attribute__((vector_size(16)));
typedef std::int32_t Vec4i __attribute__((vector_size(16)));

template<class Real> struct Lanes;

// ---- float ------------------------------------------------------------------------------------------------
struct MaskF {
  Vec8i bits;
};
template<> struct Lanes<float> {
  using Mask = MaskF;
  Vec8f v;
  Lanes() = default;
  THAW_INLINE Lanes(float s) : v{s, s, s, s, s, s, s, s} {}
  THAW_INLINE explicit Lanes(double s) : Lanes(static_cast<float>(s)) {}
  THAW_INLINE explicit Lanes(int s) : Lanes(static_cast<float>(s)) {}
  THAW_INLINE explicit Lanes(Vec8f x) : v(x) {}
  THAW_INLINE float operator[](int lane) const { return v[lane]; }
};
using LanesF = Lanes<float>;
THAW_INLINE LanesF operator+(LanesF a, LanesF b) { return LanesF(a.v + b.v); }
THAW_INLINE LanesF operator-(LanesF a, LanesF b) { return LanesF(a.v - b.v); }
THAW_INLINE LanesF operator*(LanesF a, LanesF b) { return LanesF(a.v * b.v); }
THAW_INLINE LanesF operator/(LanesF a, LanesF b) { return LanesF(a.v / b.v); }
THAW_INLINE LanesF operator-(LanesF a) { return LanesF(-a.v); }
THAW_INLINE LanesF& operator+=(LanesF& a, LanesF b) { return a = a + b; }
THAW_INLINE LanesF& operator-=(LanesF& a, LanesF b) { return a = a - b; }
THAW_INLINE MaskF operator<(LanesF a, LanesF b) { return {a.v < b.v}; }
THAW_INLINE MaskF operator>(LanesF a, LanesF b) { return {a.v > b.v}; }
THAW_INLINE MaskF operator&(MaskF a, MaskF b) { return {a.bits & b.bits}; }
THAW_INLINE LanesF select(MaskF m, LanesF a, LanesF b) { return LanesF(m.bits ? a.v : b.v); }
THAW_INLINE bool laneOf(MaskF m, int lane) { return m.bits[lane] != 0; }

// ---- double -----------------------------------------------------------------------------------------------
struct MaskD {
  Vec4l lo, hi;
};
template<> struct Lanes<double> {
  using Mask = MaskD;
  Vec4d lo, hi;
  Lanes() = default;
  THAW_INLINE Lanes(double s) : lo{s, s, s, s}, hi{s, s, s, s} {}
  THAW_INLINE explicit Lanes(int s) : Lanes(static_cast<double>(s)) {}
  THAW_INLINE Lanes(Vec4d a, Vec4d b) : lo(a), hi(b) {}
  THAW_INLINE double operator[](int lane) const { return lane < 4 ? lo[lane] : hi[lane - 4]; }
};
using LanesD = Lanes<double>;
THAW_INLINE LanesD operator+(LanesD a, LanesD b) { return {a.lo + b.lo, a.hi + b.hi}; }
THAW_INLINE LanesD operator-(LanesD a, LanesD b) { return {a.lo - b.lo, a.hi - b.hi}; }
THAW_INLINE LanesD operator*(LanesD a, LanesD b) { return {a.lo * b.lo, a.hi * b.hi}; }
THAW_INLINE LanesD operator/(LanesD a, LanesD b) { return {a.lo / b.lo, a.hi / b.hi}; }
THAW_INLINE LanesD operator-(LanesD a) { return {-a.lo, -a.hi}; }
THAW_INLINE LanesD& operator+=(LanesD& a, LanesD b) { return a = a + b; }
THAW_INLINE LanesD& operator-=(LanesD& a, LanesD b) { return a = a - b; }
THAW_INLINE MaskD operator<(LanesD a, LanesD b) { return {a.lo < b.lo, a.hi < b.hi}; }
THAW_INLINE MaskD operator>(LanesD a, LanesD b) { return {a.lo > b.lo, a.hi > b.hi}; }
THAW_INLINE MaskD operator&(MaskD a, MaskD b) { return {a.lo & b.lo, a.hi & b.hi}; }
THAW_INLINE LanesD select(MaskD m, LanesD a, LanesD b) { return {m.lo ? a.lo : b.lo, m.hi ? a.hi : b.hi}; }
THAW_INLINE LanesD widen(LanesF a) {
  return {__builtin_convertvector(__builtin_shufflevector(a.v, a.v, 0, 1, 2, 3), Vec4d),
          __builtin_convertvector(__builtin_shufflevector(a.v, a.v, 4, 5, 6, 7), Vec4d)};
}
THAW_INLINE LanesD widen(LanesD a) { return a; }
THAW_INLINE bool laneOf(MaskD m, int lane) { return (lane < 4 ? m.lo[lane] : m.hi[lane - 4]) != 0; }

#if defined(__AVX__)
}  // namespace THAW_ISA
}  // namespace thaw
#include <immintrin.h>
namespace thaw {
namespace THAW_ISA {
// One instruction each. The bits equal those of a < b ? a : b (min) and a > b ? a : b (max), also for zeros
// and NaN. For these expressions, the compiler emits two instructions.
THAW_INLINE LanesF max(LanesF a, LanesF b) {
  return LanesF(
      reinterpret_cast<Vec8f>(_mm256_max_ps(reinterpret_cast<__m256>(a.v), reinterpret_cast<__m256>(b.v))));
}
THAW_INLINE LanesF min(LanesF a, LanesF b) {
  return LanesF(
      reinterpret_cast<Vec8f>(_mm256_min_ps(reinterpret_cast<__m256>(a.v), reinterpret_cast<__m256>(b.v))));
}
THAW_INLINE Vec4d max(Vec4d a, Vec4d b) {
  return reinterpret_cast<Vec4d>(_mm256_max_pd(reinterpret_cast<__m256d>(a), reinterpret_cast<__m256d>(b)));
}
THAW_INLINE Vec4d min(Vec4d a, Vec4d b) {
  return reinterpret_cast<Vec4d>(_mm256_min_pd(reinterpret_cast<__m256d>(a), reinterpret_cast<__m256d>(b)));
}
THAW_INLINE LanesD max(LanesD a, LanesD b) { return {max(a.lo, b.lo), max(a.hi, b.hi)}; }
THAW_INLINE LanesD min(LanesD a, LanesD b) { return {min(a.lo, b.lo), min(a.hi, b.hi)}; }
THAW_INLINE LanesF sqrt(LanesF a) {
  return LanesF(reinterpret_cast<Vec8f>(_mm256_sqrt_ps(reinterpret_cast<__m256>(a.v))));
}
THAW_INLINE LanesD sqrt(LanesD a) {
  return {reinterpret_cast<Vec4d>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a.lo))),
          reinterpret_cast<Vec4d>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a.hi)))};
}
THAW_INLINE LanesF fma(LanesF a, LanesF b, LanesF c) {
  return LanesF(reinterpret_cast<Vec8f>(_mm256_fmadd_ps(
      reinterpret_cast<__m256>(a.v), reinterpret_cast<__m256>(b.v), reinterpret_cast<__m256>(c.v))));
}
THAW_INLINE Vec4d fma(Vec4d a, Vec4d b, Vec4d c) {
  return reinterpret_cast<Vec4d>(_mm256_fmadd_pd(reinterpret_cast<__m256d>(a), reinterpret_cast<__m256d>(b),
                                                 reinterpret_cast<__m256d>(c)));
}
THAW_INLINE bool any(MaskF m) {
  return !_mm256_testz_ps(reinterpret_cast<__m256>(m.bits), reinterpret_cast<__m256>(m.bits));
}
/// Returns true if any lane is negative. -0 may count as negative.
THAW_INLINE bool anyNegative(LanesF a) { return any(MaskF{reinterpret_cast<Vec8i>(a.v)}); }
#else
THAW_INLINE LanesF max(LanesF a, LanesF b) { return select(a > b, a, b); }
THAW_INLINE LanesF min(LanesF a, LanesF b) { return select(a < b, a, b); }
THAW_INLINE LanesD max(LanesD a, LanesD b) { return select(a > b, a, b); }
THAW_INLINE LanesD min(LanesD a, LanesD b) { return select(a < b, a, b); }
THAW_INLINE LanesF sqrt(LanesF a) {
  LanesF r;
  for (int l = 0; l < 8; l++) r.v[l] = __builtin_sqrtf(a.v[l]);
  return r;
}
THAW_INLINE LanesD sqrt(LanesD a) {
  LanesD r;
  for (int l = 0; l < 4; l++) {
    r.lo[l] = __builtin_sqrt(a.lo[l]);
    r.hi[l] = __builtin_sqrt(a.hi[l]);
  }
  return r;
}
THAW_INLINE LanesF fma(LanesF a, LanesF b, LanesF c) {
  LanesF r;
  for (int l = 0; l < 8; l++) r.v[l] = __builtin_fmaf(a.v[l], b.v[l], c.v[l]);
  return r;
}
THAW_INLINE Vec4d fma(Vec4d a, Vec4d b, Vec4d c) {
  Vec4d r;
  for (int l = 0; l < 4; l++) r[l] = __builtin_fma(a[l], b[l], c[l]);
  return r;
}
THAW_INLINE bool any(MaskF m) {
  const Vec4l b = reinterpret_cast<Vec4l>(m.bits);
  return (b[0] | b[1] | b[2] | b[3]) != 0;
}
THAW_INLINE bool anyNegative(LanesF a) { return any(a < LanesF(0.0f)); }
#endif
/// Returns a b + c, rounded once, with the same bits on all instruction sets. Without a hardware instruction,
/// it is a slow library call. The compiler does not contract other expressions.
THAW_INLINE LanesD fma(LanesD a, LanesD b, LanesD c) {
  return {fma(a.lo, b.lo, c.lo), fma(a.hi, b.hi, c.hi)};
}
/// Returns the dot product a . b of three components.
template<class L> THAW_INLINE L dot3(L ax, L ay, L az, L bx, L by, L bz) {
  return fma(az, bz, fma(ay, by, ax * bx));
}
THAW_INLINE bool any(MaskD m) {
  const Vec4l b = m.lo | m.hi;
  return (b[0] | b[1] | b[2] | b[3]) != 0;
}

THAW_INLINE bool anyNegative(LanesD a) { return any(a < LanesD(0.0)); }

// ---- four values of eight rows, loaded as records and transposed: no gather instructions ------------------
/// Four values of one particle. A pair sum loads whole records of the neighbours.
template<class Real> struct alignas(4 * sizeof(Real)) Record { Real a, b, c, d; };
template<class Real> struct Lanes4 { Lanes<Real> a, b, c, d; };

THAW_INLINE Vec8f load2(const Record<float>* low, const Record<float>* high) {
#if defined(__AVX__)  // The upper half is loaded from memory, because only one shuffle of two registers is
                      // possible per cycle.
  return reinterpret_cast<Vec8f>(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(&low->a)),
                                                      *reinterpret_cast<const __m128*>(high), 1));
#else
  const Vec4f l = *reinterpret_cast<const Vec4f*>(low), h = *reinterpret_cast<const Vec4f*>(high);
  return __builtin_shufflevector(l, h, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}
/// Interleaves values 0, 1 (low) or 2, 3 (high) of a and b, in each half. On Intel cores, integer unpacks use
/// two ports, but float unpacks only one (Sapphire Rapids: 0.5 and 1 cycle).
THAW_INLINE Vec8f unpackLow(Vec8f a, Vec8f b) {
  return reinterpret_cast<Vec8f>(__builtin_shufflevector(
      reinterpret_cast<Vec8i>(a), reinterpret_cast<Vec8i>(b), 0, 8, 1, 9, 4, 12, 5, 13));
}
THAW_INLINE Vec8f unpackHigh(Vec8f a, Vec8f b) {
  return reinterpret_cast<Vec8f>(__builtin_shufflevector(
      reinterpret_cast<Vec8i>(a), reinterpret_cast<Vec8i>(b), 2, 10, 3, 11, 6, 14, 7, 15));
}
/// Gives the address of the first record of a row with `stride` records.
template<std::size_t stride> struct ByRow {
  template<class R> static THAW_INLINE const R* of(const R* at, std::uint32_t row) {
    return at + stride * row;
  }
};
/// Gives the address of the record of a neighbour-list entry. An entry is twice the row. The address of a
/// 16-byte record is then one scaled operand (eight times the entry), without a shift.
struct ByEntry {
  template<class R> static THAW_INLINE const R* of(const R* at, std::uint32_t entry) {
    return reinterpret_cast<const R*>(reinterpret_cast<const char*>(at) +
                                      sizeof(R) / 2 * static_cast<std::size_t>(entry));
  }
};
/// Returns the lanes of the four values. r_l contains the values of rows l (lower half) and l + 4 (upper
/// half).
THAW_INLINE Lanes4<float> fromRows(Vec8f r0, Vec8f r1, Vec8f r2, Vec8f r3) {
  const Vec8f ab01 = unpackLow(r0, r1), cd01 = unpackHigh(r0, r1), ab23 = unpackLow(r2, r3),
              cd23 = unpackHigh(r2, r3);
  return {LanesF(__builtin_shufflevector(ab01, ab23, 0, 1, 8, 9, 4, 5, 12, 13)),
          LanesF(__builtin_shufflevector(ab01, ab23, 2, 3, 10, 11, 6, 7, 14, 15)),
          LanesF(__builtin_shufflevector(cd01, cd23, 0, 1, 8, 9, 4, 5, 12, 13)),
          LanesF(__builtin_shufflevector(cd01, cd23, 2, 3, 10, 11, 6, 7, 14, 15))};
}
template<class By> THAW_INLINE Lanes4<float> loadBy(const Record<float>* at, const std::uint32_t* rows) {
  const auto both = [&](int l) { return load2(By::of(at, rows[l]), By::of(at, rows[l + 4])); };
  return fromRows(both(0), both(1), both(2), both(3));
}
THAW_INLINE Vec4d halves(const double* low, const double* high) {
#if defined(__AVX__)  // as in load2
  return reinterpret_cast<Vec4d>(_mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(low)),
                                                      *reinterpret_cast<const __m128d*>(high), 1));
#else
  return Vec4d{low[0], low[1], high[0], high[1]};
#endif
}
template<class By>
THAW_INLINE void transpose4(const Record<double>* at, const std::uint32_t* rows, Vec4d& a, Vec4d& b, Vec4d& c,
                            Vec4d& d) {
  const Record<double>*p0 = By::of(at, rows[0]), *p1 = By::of(at, rows[1]), *p2 = By::of(at, rows[2]),
        *p3 = By::of(at, rows[3]);
  const Vec4d ab02 = halves(&p0->a, &p2->a), ab13 = halves(&p1->a, &p3->a), cd02 = halves(&p0->c, &p2->c),
              cd13 = halves(&p1->c, &p3->c);
  a = __builtin_shufflevector(ab02, ab13, 0, 4, 2, 6);
  b = __builtin_shufflevector(ab02, ab13, 1, 5, 3, 7);
  c = __builtin_shufflevector(cd02, cd13, 0, 4, 2, 6);
  d = __builtin_shufflevector(cd02, cd13, 1, 5, 3, 7);
}
template<class By> THAW_INLINE Lanes4<double> loadBy(const Record<double>* at, const std::uint32_t* rows) {
  Lanes4<double> r;
  transpose4<By>(at, rows, r.a.lo, r.b.lo, r.c.lo, r.d.lo);
  transpose4<By>(at, rows + 4, r.a.hi, r.b.hi, r.c.hi, r.d.hi);
  return r;
}
/// Loads the first record of eight rows; stride: records per row.
template<std::size_t stride = 1, class Real>
THAW_INLINE Lanes4<Real> load(const Record<Real>* at, const std::uint32_t* rows) {
  return loadBy<ByRow<stride>>(at, rows);
}
/// Loads the records of eight entries of a neighbour list.
template<class Real>
THAW_INLINE Lanes4<Real> loadListed(const Record<Real>* at, const std::uint32_t* entries) {
  return loadBy<ByEntry>(at, entries);
}

/// Inverse of fromRows.
THAW_INLINE void toRows(const Lanes4<float>& v, Vec8f (&rows)[4]) {
  const Vec8f ab0 = unpackLow(v.a.v, v.b.v), ab2 = unpackHigh(v.a.v, v.b.v), cd0 = unpackLow(v.c.v, v.d.v),
              cd2 = unpackHigh(v.c.v, v.d.v);
  rows[0] = __builtin_shufflevector(ab0, cd0, 0, 1, 8, 9, 4, 5, 12, 13);
  rows[1] = __builtin_shufflevector(ab0, cd0, 2, 3, 10, 11, 6, 7, 14, 15);
  rows[2] = __builtin_shufflevector(ab2, cd2, 0, 1, 8, 9, 4, 5, 12, 13);
  rows[3] = __builtin_shufflevector(ab2, cd2, 2, 3, 10, 11, 6, 7, 14, 15);
}
/// Returns the four values of lane l after toRows.
THAW_INLINE Vec4f rowOf(const Vec8f (&rows)[4], int l) {
  return l < 4 ? __builtin_shufflevector(rows[l & 3], rows[l & 3], 0, 1, 2, 3)
               : __builtin_shufflevector(rows[l & 3], rows[l & 3], 4, 5, 6, 7);
}
/// Inverse of load: stores four values of lanes [0, n) as records at a distance of `stride` records.
THAW_INLINE void store(const Lanes4<float>& v, int n, int stride, Record<float>* to) {
  Vec8f rows[4];
  toRows(v, rows);
  for (int l = 0; l < 8; l++)
    if (l < n) *reinterpret_cast<Vec4f*>(to + l * stride) = rowOf(rows, l);
}
THAW_INLINE void store(const Lanes4<double>& v, int n, int stride, Record<double>* to) {
  for (int l = 0; l < n; l++) to[l * stride] = {v.a[l], v.b[l], v.c[l], v.d[l]};
}

/// Loads eight consecutive values.
THAW_INLINE LanesF loadRow(const float* p) { return LanesF(*reinterpret_cast<const Vec8f*>(p)); }
THAW_INLINE LanesD loadRow(const double* p) {
  return {*reinterpret_cast<const Vec4d*>(p), *reinterpret_cast<const Vec4d*>(p + 4)};
}
THAW_INLINE void toDoubles(LanesD a, double* p) {
  *reinterpret_cast<Vec4d*>(p) = a.lo;
  *reinterpret_cast<Vec4d*>(p + 4) = a.hi;
}

/// Unit of position differences, in support radii: 2^-24 for fixed-point positions, whose bits are stored in
/// float records. It is a power of two, so a sum may apply it at the end with the same bits.
template<class Real> inline constexpr double lengthUnit = sizeof(Real) == 4 ? 1.0 / 16777216 : 1.0;
/// Returns the difference own - other in units of lengthUnit. It is exact before one rounding to float.
THAW_INLINE LanesF unitDifference(LanesF own, LanesF other) {
  return LanesF(__builtin_convertvector(
      reinterpret_cast<Vec8i>(reinterpret_cast<Vec8u>(own.v) - reinterpret_cast<Vec8u>(other.v)), Vec8f));
}
/// In double precision, records hold positions in support radii.
THAW_INLINE LanesD unitDifference(LanesD own, LanesD other) { return own - other; }
/// Returns the difference own - other in support radii.
THAW_INLINE LanesF positionDifference(LanesF own, LanesF other) {
  return LanesF(lengthUnit<float>) * unitDifference(own, other);
}
THAW_INLINE LanesD positionDifference(LanesD own, LanesD other) { return own - other; }

/// Prefetch distance, in entries of a list of neighbours or bonds. Many hardware prefetchers are too slow for
/// these lists.
inline constexpr std::size_t listAhead = 320;

}  // namespace THAW_ISA
}  // namespace thaw
