// SPDX-License-Identifier: Apache-2.0
// Loads for the bond loops: conversions, position differences, and both ends of eight bonds. Only code that
// is compiled per instruction set includes this.
#pragma once
#include "core/simd/wide.hpp"
#include "core/solid/elasticity/elastic_kernels.hpp"

namespace thaw {
namespace THAW_ISA {

THAW_INLINE void narrow(LanesD a, LanesD& out) { out = a; }
THAW_INLINE void narrow(LanesD a, LanesF& out) {
  const Vec4f lo = __builtin_convertvector(a.lo, Vec4f), hi = __builtin_convertvector(a.hi, Vec4f);
  out = LanesF(__builtin_shufflevector(lo, hi, 0, 1, 2, 3, 4, 5, 6, 7));
}
/// Loads eight doubles, 64-byte aligned.
template<class Real> THAW_INLINE Lanes<Real> fromDoubles(const double* p) {
  Lanes<Real> r;
  narrow(loadRow(p), r);
  return r;
}

/// Position differences in units of ElasticArrays::unit. They are exact except for one final rounding, and
/// antisymmetric.
template<class Real, bool periodic> struct Places;
template<bool periodic> struct Places<float, periodic> {
  std::int32_t period[3];
  explicit Places(const ElasticArrays& a) {
    for (int k = 0; k < 3; k++)
      period[k] = static_cast<std::int32_t>(
          static_cast<std::uint32_t>(static_cast<std::uint64_t>(a.period[k] + 0.5)));
  }
  static THAW_INLINE Vec8i absolute(Vec8i d) { return d < 0 ? -d : d; }
  THAW_INLINE LanesF one(LanesF from, LanesF to, int axis) const {
    // The subtraction wraps around by design.
    const Vec8u u = reinterpret_cast<Vec8u>(to.v) - reinterpret_cast<Vec8u>(from.v);
    Vec8i d = reinterpret_cast<Vec8i>(u);
    if constexpr (periodic) {
      const std::uint32_t p = static_cast<std::uint32_t>(period[axis]);
      const Vec8i low = reinterpret_cast<Vec8i>(u - p), high = reinterpret_cast<Vec8i>(u + p),
                  size = absolute(d);
      d = absolute(low) < size ? low : absolute(high) < size ? high : d;
    }
    (void)axis;
    return LanesF(__builtin_convertvector(d, Vec8f));
  }
  THAW_INLINE Vec3<LanesF> operator()(const Vec3<LanesF>& from, const Vec3<LanesF>& to) const {
    return {one(from.x, to.x, 0), one(from.y, to.y, 1), one(from.z, to.z, 2)};
  }
};
template<bool periodic> struct Places<double, periodic> {
  LanesD period[3];
  explicit Places(const ElasticArrays& a)
      : period{LanesD(a.period[0]), LanesD(a.period[1]), LanesD(a.period[2])} {}
  THAW_INLINE LanesD one(LanesD from, LanesD to, int axis) const {
    const LanesD d = to - from;
    if constexpr (!periodic) return (void)axis, d;
    const LanesD half = LanesD(0.5) * period[axis];
    const LanesD none(0.0);
    // Period 0: not periodic.
    return select((none < half) & (half < d), d - period[axis],
                  select((none < half) & (d < -half), d + period[axis], d));
  }
  THAW_INLINE Vec3<LanesD> operator()(const Vec3<LanesD>& from, const Vec3<LanesD>& to) const {
    return {one(from.x, to.x, 0), one(from.y, to.y, 1), one(from.z, to.z, 2)};
  }
};

struct alignas(64) Rows {
  std::uint32_t row[8];
};
/// Returns the rows of a group's solids; lanes past the last solid repeat the first.
THAW_INLINE Rows rowsOfSolids(std::size_t first, int n) {
  Rows r;
  for (int l = 0; l < 8; l++)
    r.row[l] = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(l < n ? l : 0);
  return r;
}
template<class Real>
THAW_INLINE Vec3<Lanes<Real>> loadVector(const void* x, const void* y, const void* z, std::size_t at) {
  return {loadRow(static_cast<const Real*>(x) + at), loadRow(static_cast<const Real*>(y) + at),
          loadRow(static_cast<const Real*>(z) + at)};
}
template<class Real> THAW_INLINE Lanes<Real> square(const Vec3<Lanes<Real>>& v) {
  return dot3(v.x, v.y, v.z, v.x, v.y, v.z);
}

/// BondEnd data of eight rows as four records of four values. Unused values are not loaded.
template<class Real> struct EightEnds {
  using T = Lanes<Real>;
  Lanes4<Real> first, second;
  THAW_INLINE Vec3<T> displacement() const { return {first.a, first.b, first.c}; }
  THAW_INLINE Vec3<T> reference() const { return {first.d, second.a, second.b}; }
};
/// Hourglass stiffness k and flux Phi of eight rows (elastic.hpp).
template<class Real> struct EightFluxes {
  Lanes<Real> k;
  Mat3<Lanes<Real>> flux;
};
template<class Real> THAW_INLINE EightEnds<Real> loadEnds(const Record<Real>* at, const std::uint32_t* rows) {
  return {load<4>(at, rows), load<4>(at + 1, rows)};
}
template<class Real>
THAW_INLINE EightFluxes<Real> loadFluxes(const EightEnds<Real>& ends, const Record<Real>* at,
                                         const std::uint32_t* rows) {
  const Lanes4<Real> third = load<4>(at + 2, rows), fourth = load<4>(at + 3, rows);
  return {
      ends.second.c,
      {{{ends.second.d, third.a, third.b}, {third.c, third.d, fourth.a}, {fourth.b, fourth.c, fourth.d}}}};
}
/// Stores fluxes into the rows of n solids starting at the first. Positions do not change.
template<class Real>
THAW_INLINE void storeFluxes(const EightEnds<Real>& ends, const EightFluxes<Real>& f, int n,
                             Record<Real>* to) {
  const Mat3<Lanes<Real>>& m = f.flux;
  store({ends.second.a, ends.second.b, f.k, m.row[0].x}, n, 4, to + 1);
  store({m.row[0].y, m.row[0].z, m.row[1].x, m.row[1].y}, n, 4, to + 2);
  store({m.row[1].z, m.row[2].x, m.row[2].y, m.row[2].z}, n, 4, to + 3);
}

/// Eight bonds: reference X_ij, current vector x_ij, displacement u_ij = x_ij - X_ij, weight, and the loaded
/// other ends.
template<class Real> struct EightBonds {
  Vec3<Lanes<Real>> reference, current, u;
  Lanes<Real> weight;
  EightEnds<Real> ends;
};

/// Loads the bonds of a group's solids. vectors: references and weights are stored per bond, in m. Otherwise
/// references are differences of the ends' references in units of ElasticArrays::unit, and the weight is (1 -
/// X^2/h^2)^3. The end of an unused entry is the solid itself, so all its values except the weight are then
/// zero.
template<class Real, bool periodic, bool vectors> struct BondLoader {
  using T = Lanes<Real>;
  const ElasticArrays& a;
  const Record<Real>* records;
  Places<Real, periodic> difference;
  T unit, perSupport2;
  EightEnds<Real> own;
  std::size_t ahead;  ///< prefetch distance, which leads to the same bond index in the next group. Entries
                      ///< past a group's longest row are never read
  explicit BondLoader(const ElasticArrays& a)
      : a(a),
        records(static_cast<const Record<Real>*>(a.end)),
        difference(a),
        unit(static_cast<Real>(a.unit)),
        perSupport2(static_cast<Real>(a.perSupport2 * scale() * scale())),
        ahead(8 * a.capacity) {}
  /// Unit of the returned lengths (m).
  double scale() const { return vectors || sizeof(Real) == 8 ? 1 : a.unit; }
  THAW_INLINE void begin(const Rows& self) { own = loadEnds(records, self.row); }
  THAW_INLINE EightBonds<Real> operator()(std::size_t at) const {
    EightBonds<Real> b;
    __builtin_prefetch(a.neighbour + at + ahead);
    b.ends = loadEnds(records, a.neighbour + at);
    if constexpr (vectors) {
      for (const void* array : {a.x, a.y, a.z, a.weight})
        __builtin_prefetch(static_cast<const Real*>(array) + at + ahead);
      Vec3<T> x = difference(own.displacement(), b.ends.displacement());
      if constexpr (sizeof(Real) == 4) x = {x.x * unit, x.y * unit, x.z * unit};
      b.reference = loadVector<Real>(a.x, a.y, a.z, at);
      b.current = x;  // X + u would be rounded for large stretches; with X_ji = -X_ij both ends have the same
                      // u bit by bit
      b.u = {x.x - b.reference.x, x.y - b.reference.y, x.z - b.reference.z};
      b.weight = loadRow(static_cast<const Real*>(a.weight) + at);
    } else {
      b.u = difference(own.displacement(), b.ends.displacement());
      b.reference = difference(own.reference(), b.ends.reference());
      b.current = {b.reference.x + b.u.x, b.reference.y + b.u.y, b.reference.z + b.u.z};
      const T q = fma(square(b.reference), -perSupport2, T(Real(1)));
      b.weight = q * q * q;
    }
    return b;
  }
};

template<class Real> THAW_INLINE void storeMatrix(const Mat3<Lanes<Real>>& m, double out[9][8]) {
  for (int r = 0; r < 3; r++) {
    toDoubles(widen(m.row[r].x), out[3 * r]);
    toDoubles(widen(m.row[r].y), out[3 * r + 1]);
    toDoubles(widen(m.row[r].z), out[3 * r + 2]);
  }
}
template<class Real> THAW_INLINE Mat3<Lanes<Real>> loadMatrix(const double in[9][8]) {
  Mat3<Lanes<Real>> m;
  for (int r = 0; r < 3; r++)
    m.row[r] = {fromDoubles<Real>(in[3 * r]), fromDoubles<Real>(in[3 * r + 1]),
                fromDoubles<Real>(in[3 * r + 2])};
  return m;
}
template<class T> THAW_INLINE Mat3<LanesD> widened(const Mat3<T>& m) {
  Mat3<LanesD> w;
  for (int r = 0; r < 3; r++) w.row[r] = {widen(m.row[r].x), widen(m.row[r].y), widen(m.row[r].z)};
  return w;
}
template<class Real> THAW_INLINE Sym3<Lanes<Real>> loadTensor(const double in[6][8]) {
  return {fromDoubles<Real>(in[0]), fromDoubles<Real>(in[1]), fromDoubles<Real>(in[2]),
          fromDoubles<Real>(in[3]), fromDoubles<Real>(in[4]), fromDoubles<Real>(in[5])};
}

}  // namespace THAW_ISA
}  // namespace thaw
