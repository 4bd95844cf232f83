// SPDX-License-Identifier: Apache-2.0
// The two bond loops: each lane is a solid and sums its bonds in order.
#include "core/solid/elasticity/law_lanes.hpp"
#include "core/solid/laws/volume.hpp"

namespace thaw {
namespace THAW_ISA {

namespace {

/// Adds w u (x) X of bonds [at, end) to sum. tears: excess becomes the maximum of x^2 - stretch2 X^2, > 0 if
/// some bond may break.
template<bool tears, class Real, bool periodic, bool vectors>
THAW_INLINE void sumGradient(const BondLoader<Real, periodic, vectors>& bonds, std::size_t at,
                             std::size_t end, const Lanes<Real>& stretch2, Mat3<Lanes<Real>>& sum,
                             Lanes<Real>& excess) {
  const ElasticArrays& a = bonds.a;
  // Local rows stay in registers; the matrix itself would stay in memory.
  Vec3<Lanes<Real>> x = sum.row[0], y = sum.row[1], z = sum.row[2];
  for (; at < end; at += 8) {
    const EightBonds<Real> b = bonds(at);
    const Vec3<Lanes<Real>>& X = b.reference;
    const Vec3<Lanes<Real>> wX{b.weight * X.x, b.weight * X.y, b.weight * X.z};
    x = {fma(b.u.x, wX.x, x.x), fma(b.u.x, wX.y, x.y), fma(b.u.x, wX.z, x.z)};
    y = {fma(b.u.y, wX.x, y.x), fma(b.u.y, wX.y, y.y), fma(b.u.y, wX.z, y.z)};
    z = {fma(b.u.z, wX.x, z.x), fma(b.u.z, wX.y, z.y), fma(b.u.z, wX.z, z.z)};
    if constexpr (tears) {
      Lanes<Real> reference = square<Real>(X);
      if constexpr (vectors) reference = max(reference, square<Real>(loadVector<Real>(a.rx, a.ry, a.rz, at)));
      excess = max(excess, square<Real>(b.current) - stretch2 * reference);
    }
  }
  sum = {{x, y, z}};
}

/// Returns sum w |u - grad u X|^2 of bonds [at, end).
template<class Real, bool periodic, bool vectors>
THAW_INLINE Lanes<Real> sumErrors(const BondLoader<Real, periodic, vectors>& bonds, std::size_t at,
                                  std::size_t end, const Mat3<Lanes<Real>>& gradient) {
  using T = Lanes<Real>;
  T errors(Real(0));
  for (; at < end; at += 8) {
    const EightBonds<Real> b = bonds(at);
    const Vec3<T> e{b.u.x - dot(gradient.row[0], b.reference), b.u.y - dot(gradient.row[1], b.reference),
                    b.u.z - dot(gradient.row[2], b.reference)};
    errors += b.weight * (e.x * e.x + e.y * e.y + e.z * e.z);
  }
  return errors;
}

template<class Real, bool periodic, bool vectors>
__attribute__((flatten)) void deformationOf(ElasticArrays& a) {
  using T = Lanes<Real>;
  BondLoader<Real, periodic, vectors> bonds(a);
  const T scale2(static_cast<Real>(bonds.scale() * bonds.scale()));
  alignas(64) double gradU[9][8], inverse[6][8], energy[8], more[8];
  LaneConstants c;
  alignas(64) PlasticLanes plastic;
  T largest(Real(1));
  const T breakStretch2(static_cast<Real>(a.breakStretch2));
  for (std::size_t gi = 0; gi < a.groupCount; gi++) {
    const std::size_t g = a.groups[gi], s0 = 8 * g, base = g * a.capacity * 8;
    const int n = a.owned - s0 < 8 ? static_cast<int>(a.owned - s0) : 8;
    // Data written lane by lane and read as vectors is stored before the loop, to avoid store-forwarding
    // stalls.
    loadLaneConstants(a, s0, n, c);
    for (int l = 0; l < 8; l++) {
      const Sym3d m = l < n ? a.momentInverse[s0 + static_cast<std::size_t>(l)] : Sym3d{};
      inverse[0][l] = m.xx, inverse[1][l] = m.yy, inverse[2][l] = m.zz, inverse[3][l] = m.xy,
      inverse[4][l] = m.yz, inverse[5][l] = m.xz;
    }
    bonds.begin(rowsOfSolids(s0, n));
    const std::size_t end = base + std::size_t(a.bondCount[g]) * 8;
    Mat3<T> sum{};
    T excess(Real(0));
    if (a.stretched) sumGradient<true>(bonds, base, end, breakStretch2, sum, excess);
    else sumGradient<false>(bonds, base, end, breakStretch2, sum, excess);
    if constexpr (!vectors && sizeof(Real) == 4) sum = scale2 * sum;
    if (a.stretched) a.stretched[g] = any(T(Real(0)) < excess);
    const Sym3<T> momentInverse = loadTensor<Real>(inverse);
    Mat3<T> gradient = times(sum, momentInverse);
    if (a.deformation || a.plastic || a.singularLanes[g] != 0) storeMatrix<Real>(gradient, gradU);
    if (a.singularLanes[g] != 0) {
      for (int l = 0; l < n; l++)
        if (a.singularLanes[g] >> l & 1) completeLane(a, s0 + static_cast<std::size_t>(l), l, gradU);
      gradient = loadMatrix<Real>(gradU);
    }
    if (c.anyHourglassYield) {
      const double scale = bonds.scale();
      toDoubles(widen(sumErrors(bonds, base, end, gradient)) * LanesD(scale * scale), more);
      for (int l = 0; l < n; l++) yieldHourglass(a, s0 + static_cast<std::size_t>(l), l, c, more);
    }
    Mat3<T> f = gradient;
    f.row[0].x += T(Real(1));
    f.row[1].y += T(Real(1));
    f.row[2].z += T(Real(1));

    const T volume = fromDoubles<Real>(c.volume);
    // Laws take the elastic part Fe of F = Fe Fp.
    Mat3<T> elasticGradient = gradient, fe = f, plasticInverse{};
    if (a.plastic) {
      for (int l = 0; l < 8; l++) {
        if (l < n) flowLane(a, c.constants[l], s0 + static_cast<std::size_t>(l), gradU, l, plastic);
        else
          for (int q = 0; q < 9; q++) plastic.elastic[q][l] = plastic.inverse[q][l] = 0;
      }
      elasticGradient = fe = loadMatrix<Real>(plastic.elastic);
      plasticInverse = loadMatrix<Real>(plastic.inverse);
      fe.row[0].x += T(Real(1));
      fe.row[1].y += T(Real(1));
      fe.row[2].z += T(Real(1));
    }
    // The formula of a lane depends on its own material only, never on the other solids of its group.
    Mat3<T> piola;
    const unsigned softened = respond<Real>({c, elasticGradient, fe, a.energy}, piola, energy);
    for (int l = 0; softened != 0 && l < n; l++)
      a.squeezed += (softened >> l & 1) && c.active[l] > 0 && !(c.volumeStiffness[l] > 0);
    if (c.anyVolumeStiffness) {
      const T stiffness = fromDoubles<Real>(c.volumeStiffness);
      piola = piola + volumeStress(fe, stiffness);
      if (a.energy) toDoubles(loadRow(energy) + widen(volumeEnergy(fe, stiffness)), energy);
    }
    if (c.anyHourglassYield && a.energy)
      for (int l = 0; l < n; l++) energy[l] += more[l];
    if (a.plastic) piola = piola + piola * transpose(plasticInverse);

    // flux = V P A^-1 - k grad u
    Mat3<T> flux = volume * times(piola, momentInverse) - fromDoubles<Real>(c.hourglass) * gradient;
    if (a.singularLanes[g] != 0) {
      alignas(64) double sums[9][8], stress[9][8], fluxes[9][8];
      storeMatrix<Real>(sum, sums), storeMatrix<Real>(piola, stress), storeMatrix<Real>(flux, fluxes);
      for (int l = 0; l < n; l++)
        if (a.singularLanes[g] >> l & 1)
          addNormalStress(a, c, s0 + static_cast<std::size_t>(l), l, {sums, gradU, stress, fluxes});
      flux = loadMatrix<Real>(fluxes);
    }
    const T j = determinant(f);
    const T size = dot(fe.row[0], fe.row[0]) + dot(fe.row[1], fe.row[1]) + dot(fe.row[2], fe.row[2]);
    const T stretch2 = select(T(Real(0.5)) < fromDoubles<Real>(c.active), size - T(Real(2)), T(Real(1)));
    largest = max(largest, stretch2);
    if (a.groupStretch2) {
      double& most = a.groupStretch2[g] = 1;
      for (int l = 0; l < n; l++)
        if (static_cast<double>(stretch2[l]) > most) most = static_cast<double>(stretch2[l]);
    }
    storeFluxes(bonds.own, {fromDoubles<Real>(c.hourglass), flux}, n,
                static_cast<Record<Real>*>(a.end) + 4 * s0);
    for (int l = 0; a.damping && l < n; l++) a.dragColumn[s0 + static_cast<std::size_t>(l)] = c.drag[l];
    for (int l = 0; a.deformation && l < n; l++)
      for (int r = 0; r < 3 && c.active[l] > 0; r++)
        a.deformation[s0 + static_cast<std::size_t>(l)].row[r] = {
            gradU[3 * r][l] + (r == 0), gradU[3 * r + 1][l] + (r == 1), gradU[3 * r + 2][l] + (r == 2)};
    for (int l = 0; a.energy && l < n; l++)
      if (c.active[l] > 0) a.energyColumn[s0 + static_cast<std::size_t>(l)] = c.volume[l] * energy[l];
    for (int l = 0; l < n; l++) a.inverted += !(j[l] > 0) && c.active[l] > 0;
  }
  for (int l = 0; l < 8; l++)
    if (static_cast<double>(largest[l]) > a.maxStretch2) a.maxStretch2 = static_cast<double>(largest[l]);
}

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
    const bool oneFrame = vectors && a.ownFrames[g] == 0;  // for most groups the reverse vector is not read
    LanesD fx(0.0), fy(0.0), fz(0.0), lost(0.0);  // sums in double: momentum is conserved to double rounding
                                                  // in single precision too
    T errors(Real(0));
    for (std::size_t at = base, end = base + std::size_t(a.bondCount[g]) * 8; at < end; at += 8) {
      const std::uint32_t* rows = a.neighbour + at;
      const EightBonds<Real> b = bonds(at);
      const Vec3<T>&ref = b.reference, &u = b.u;
      // Same as loadFluxes, without a struct that would spill to memory.
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
        // (term of i) - (term of j): the other end computes the exact negative.
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
      // Half of each bond's loss at each end.
      for (int l = 0; l < n; l++)
        a.dissipated[s0 + static_cast<std::size_t>(l)] += 0.5 * scale * out[3][l] * a.dt;
    if (energy)
      for (int l = 0; l < n; l++)
        a.energyColumn[s0 + static_cast<std::size_t>(l)] += 0.5 * scale * scale *
                                                            static_cast<double>(i.k[l]) *
                                                            static_cast<double>(errors[l]);
  }
}

template<class Real, bool periodic> void deformationIn(ElasticArrays& a) {
  a.vectors ? deformationOf<Real, periodic, true>(a) : deformationOf<Real, periodic, false>(a);
}
void deformation(ElasticArrays& a) {
  if (a.precision == Precision::Single)
    return a.periodic ? deformationIn<float, true>(a) : deformationIn<float, false>(a);
  return a.periodic ? deformationIn<double, true>(a) : deformationIn<double, false>(a);
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
constexpr ElasticKernels set{THAW_TEXT(THAW_ISA) + 4, deformation, forces};  // "isa_avx2" without "isa_"
#undef THAW_TEXT
#undef THAW_TEXT2

}  // namespace

const ElasticKernels& elasticKernelSet();
const ElasticKernels& elasticKernelSet() { return set; }

}  // namespace THAW_ISA
}  // namespace thaw
