// SPDX-License-Identifier: Apache-2.0
// The two bond loops. Each lane is a solid and sums its bonds in order.
#include "core/solid/elasticity/deformation_lanes.hpp"
#include "core/solid/laws/laws.hpp"

namespace thaw {
namespace THAW_ISA {

THAW_INLINE Mat3<LanesD> select(MaskD m, const Mat3<LanesD>& a, const Mat3<LanesD>& b) {
  Mat3<LanesD> r;
  for (int k = 0; k < 3; k++)
    r.row[k] = {select(m, a.row[k].x, b.row[k].x), select(m, a.row[k].y, b.row[k].y),
                select(m, a.row[k].z, b.row[k].z)};
  return r;
}

/// Vector version, for eight matrices F, of the function in core/solid/laws/corotated.hpp. Each lane stops
/// independently, so its bits do not depend on its group. Lanes for which Newton's iteration does not apply
/// (nearly singular or inverted F) are computed one by one.
THAW_INLINE Mat3<LanesD> nearestRotation(const Mat3<LanesD>& f) {
  const LanesD size = doubleDot(f, f) / LanesD(3.0);
  const MaskD usable = determinant(f) > LanesD(newtonsShare) * size * sqrt(size);
  Mat3<LanesD> rotation = select(usable, f, identity3<LanesD>());
  MaskD going = usable;
  for (int n = 0; n < newtonsSteps && any(going); n++) {
    const Mat3<LanesD> next = towardsRotation(rotation), change = next - rotation;
    rotation = select(going, next, rotation);
    going = going & (doubleDot(change, change) > LanesD(newtonsEnd));
  }
  const MaskD hard{~usable.lo | going.lo, ~usable.hi | going.hi};
  if (!any(hard)) return rotation;
  alignas(64) double from[9][8], to[9][8];
  storeMatrix<double>(f, from), storeMatrix<double>(rotation, to);
  for (int l = 0; l < 8; l++)
    if (laneOf(hard, l)) nearestRotationOfLane(from, l, to);
  return loadMatrix<double>(to);
}

namespace {

/// The laws of the library.
struct LibraryLaws {
  template<class F> static THAW_INLINE bool at(const ElasticLaw& law, F&& f) {
    return BuiltInLaws::at(law.builtIn, f);
  }
};

template<class Real>
THAW_INLINE Lanes<Real> sumTimes(const Vec3<Lanes<Real>>& a, const Vec3<Lanes<Real>>& b,
                                 const Vec3<Lanes<Real>>& v) {
  return dot3(a.x + b.x, a.y + b.y, a.z + b.z, v.x, v.y, v.z);
}
template<class Real> THAW_INLINE Lanes<Real> times3(const Vec3<Lanes<Real>>& a, const Vec3<Lanes<Real>>& v) {
  return dot3(a.x, a.y, a.z, v.x, v.y, v.z);
}
template<class Real>
THAW_INLINE Vec3<Lanes<Real>> apply(const Mat3<Lanes<Real>>& m, const Vec3<Lanes<Real>>& v) {
  return {times3<Real>(m.row[0], v), times3<Real>(m.row[1], v), times3<Real>(m.row[2], v)};
}

template<class Real, bool periodic, bool vectors, bool more> void forcesOf(const ElasticArrays& a) {
  using T = Lanes<Real>;
  const bool damping = more && a.damping, energy = more && a.energy;
  const auto* motion = static_cast<const Record<Real>*>(a.motion);
  BondLoader<Real, periodic, vectors> bonds(a);
  const double scale = bonds.scale();
  const T perScale(static_cast<Real>(1 / scale));
  alignas(64) double out[4][8];
  for (std::size_t gi = 0; gi < a.groupCount; gi++) {
    const std::size_t g = a.groups[gi], s0 = 8 * g, base = g * a.capacity * 8;
    const int n = a.owned - s0 < 8 ? static_cast<int>(a.owned - s0) : 8;
    const Rows self = rowsOfSolids(s0, n);
    bonds.begin(self);
    const EightFluxes<Real> i = loadFluxes(bonds.own, bonds.records, self.row);
    Lanes4<Real> vi{};
    if (damping) vi = load(motion, self.row);
    Mat3<T> gradient{};
    if (energy) {
      alignas(64) double gradU[9][8];
      for (int l = 0; l < 8; l++)
        for (int r = 0; r < 3; r++) {
          const Vec3d& row = a.deformation[self.row[l]].row[r];
          gradU[3 * r][l] = row.x - (r == 0), gradU[3 * r + 1][l] = row.y - (r == 1),
                    gradU[3 * r + 2][l] = row.z - (r == 2);
        }
      gradient = loadMatrix<Real>(gradU);
    }
    const bool oneFrame = vectors && a.ownFrames[g] == 0;  // most groups do not read the reverse vector
    LanesD fx(0.0), fy(0.0), fz(0.0), lost(0.0);  // sums in double precision, so momentum is conserved to
                                                  // double rounding even with single-precision data
    T errors(Real(0));
    for (std::size_t at = base, end = base + std::size_t(a.bondCount[g]) * 8; at < end; at += 8) {
      const std::uint32_t* rows = a.neighbour + at;
      const EightBonds<Real> b = bonds(at);
      const Vec3<T>&ref = b.reference, &u = b.u;
      // The same as loadFluxes, but without a struct that would spill to memory.
      const Lanes4<Real> third = load<4>(bonds.records + 2, rows), fourth = load<4>(bonds.records + 3, rows);
      const T k = b.ends.second.c;
      const Vec3<T> j0{b.ends.second.d, third.a, third.b}, j1{third.c, third.d, fourth.a},
          j2{fourth.b, fourth.c, fourth.d};
      Vec3<T> t;
      if (oneFrame) {  // equals the next branch for back = -ref, to the last bit
        const Vec3<T> ours = apply<Real>(i.flux, ref),
                      theirs{times3<Real>(j0, ref), times3<Real>(j1, ref), times3<Real>(j2, ref)};
        t = {fma(i.k, u.x, ours.x) + fma(k, u.x, theirs.x), fma(i.k, u.y, ours.y) + fma(k, u.y, theirs.y),
             fma(i.k, u.z, ours.z) + fma(k, u.z, theirs.z)};
      } else if constexpr (vectors) {
        const Vec3<T> x = b.current, back = loadVector<Real>(a.rx, a.ry, a.rz, at),
                      v{x.x + back.x, x.y + back.y, x.z + back.z};
        const Vec3<T> ours = apply<Real>(i.flux, ref),
                      theirs{times3<Real>(j0, back), times3<Real>(j1, back), times3<Real>(j2, back)};
        // The term of i minus the term of j. The other end computes the exact negative.
        t = {fma(i.k, u.x, ours.x) - fma(-k, v.x, theirs.x), fma(i.k, u.y, ours.y) - fma(-k, v.y, theirs.y),
             fma(i.k, u.z, ours.z) - fma(-k, v.z, theirs.z)};
      } else {
        const T both = i.k + k;
        t = {fma(both, u.x, sumTimes<Real>(i.flux.row[0], j0, ref)),
             fma(both, u.y, sumTimes<Real>(i.flux.row[1], j1, ref)),
             fma(both, u.z, sumTimes<Real>(i.flux.row[2], j2, ref))};
      }
      if (damping) {
        const Lanes4<Real> vj = load(motion, rows);
        const Vec3<T> x = b.current;
        const T length2 = square<Real>(x), some = select(length2 > T(Real(0)), length2, T(Real(1)));
        const T along = (vj.a - vi.a) * x.x + (vj.b - vi.b) * x.y + (vj.c - vi.c) * x.z;
        const T c = (vi.d + vj.d) * perScale * along / some;  // per weight
        t = {t.x + c * x.x, t.y + c * x.y, t.z + c * x.z};
        lost += wide(b.weight * c * along);
      }
      if (energy) {
        const Vec3<T> e{u.x - dot(gradient.row[0], ref), u.y - dot(gradient.row[1], ref),
                        u.z - dot(gradient.row[2], ref)};
        errors += b.weight * (e.x * e.x + e.y * e.y + e.z * e.z);
      }
      fx += wide(b.weight * t.x);
      fy += wide(b.weight * t.y);
      fz += wide(b.weight * t.z);
    }
    toDoubles(fx, out[0]), toDoubles(fy, out[1]), toDoubles(fz, out[2]), toDoubles(lost, out[3]);
    for (int l = 0; l < n; l++)
      a.force[s0 + static_cast<std::size_t>(l)] = {scale * out[0][l], scale * out[1][l], scale * out[2][l]};
    if (damping)
      // Each end records half of the bond's loss.
      for (int l = 0; l < n; l++)
        a.dissipated[s0 + static_cast<std::size_t>(l)] += 0.5 * scale * out[3][l] * a.dt;
    if (energy)
      for (int l = 0; l < n; l++)
        a.energyColumn[s0 + static_cast<std::size_t>(l)] += 0.5 * scale * scale *
                                                            static_cast<double>(i.k[l]) *
                                                            static_cast<double>(errors[l]);
  }
}

template<class Real, bool periodic, bool more> void forcesWith(const ElasticArrays& a) {
  a.vectors ? forcesOf<Real, periodic, true, more>(a) : forcesOf<Real, periodic, false, more>(a);
}
template<class Real, bool periodic> void forcesIn(const ElasticArrays& a) {
  a.damping || a.energy ? forcesWith<Real, periodic, true>(a) : forcesWith<Real, periodic, false>(a);
}
void forces(const ElasticArrays& a) {
  if (a.precision == Precision::Single)
    return a.periodic ? forcesIn<float, true>(a) : forcesIn<float, false>(a);
  return a.periodic ? forcesIn<double, true>(a) : forcesIn<double, false>(a);
}

#define THAW_TEXT2(x) #x
#define THAW_TEXT(x) THAW_TEXT2(x)
constexpr ElasticKernels set{THAW_TEXT(THAW_ISA) + 4, deformation<LibraryLaws>, forces};  // "isa_avx2"
                                                                                          // without "isa_"
#undef THAW_TEXT
#undef THAW_TEXT2

}  // namespace

const ElasticKernels& elasticKernelSet();
const ElasticKernels& elasticKernelSet() { return set; }

}  // namespace THAW_ISA
}  // namespace thaw
