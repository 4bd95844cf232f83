// The two loops over bonds: a lane is a slot, and sums its bonds one after another in their order.
#include "core/simd/wide.hpp"
#include "core/solid/elastic_kernels.hpp"
#include "core/solid/laws/green.hpp"
#include "core/solid/laws/neo_hookean.hpp"
#include "core/solid/laws/volume.hpp"

namespace thaw {
namespace THAW_ISA {

namespace {

THAW_INLINE void narrow(LanesD a, LanesD& out) { out = a; }
THAW_INLINE void narrow(LanesD a, LanesF& out) {
  const Vec4f lo = __builtin_convertvector(a.lo, Vec4f), hi = __builtin_convertvector(a.hi, Vec4f);
  out = LanesF(__builtin_shufflevector(lo, hi, 0, 1, 2, 3, 4, 5, 6, 7));
}
/// Eight doubles, 64-byte aligned.
template<class Real> THAW_INLINE Lanes<Real> fromDoubles(const double* p) {
  Lanes<Real> r;
  narrow(loadRow(p), r);
  return r;
}
THAW_INLINE void toDoubles(LanesD a, double* p) {
  *reinterpret_cast<Vec4d*>(p) = a.lo;
  *reinterpret_cast<Vec4d*>(p + 4) = a.hi;
}

/// Differences of places, m: exact before one rounding, and antisymmetric.
template<class Real, bool periodic> struct Places;
template<bool periodic> struct Places<float, periodic> {
  LanesF unit;
  std::int32_t period[3];
  explicit Places(const ElasticArrays& a) : unit(static_cast<float>(a.unit)) {
    for (int k = 0; k < 3; k++) period[k] = static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(a.period[k] + 0.5)));
  }
  static THAW_INLINE Vec8i absolute(Vec8i d) { return d < 0 ? -d : d; }
  THAW_INLINE LanesF one(LanesF from, LanesF to, int axis) const {
    const Vec8u u = reinterpret_cast<Vec8u>(to.v) - reinterpret_cast<Vec8u>(from.v);  // wraps around by design
    Vec8i d = reinterpret_cast<Vec8i>(u);
    if constexpr (periodic) {
      const std::uint32_t p = static_cast<std::uint32_t>(period[axis]);
      const Vec8i low = reinterpret_cast<Vec8i>(u - p), high = reinterpret_cast<Vec8i>(u + p), size = absolute(d);
      d = absolute(low) < size ? low : absolute(high) < size ? high : d;
    }
    (void)axis;
    return LanesF(__builtin_convertvector(d, Vec8f)) * unit;
  }
  THAW_INLINE Vec3<LanesF> operator()(const Lanes4<float>& from, const Lanes4<float>& to) const {
    return {one(from.a, to.a, 0), one(from.b, to.b, 1), one(from.c, to.c, 2)};
  }
};
template<bool periodic> struct Places<double, periodic> {
  LanesD period[3];
  explicit Places(const ElasticArrays& a) : period{LanesD(a.period[0]), LanesD(a.period[1]), LanesD(a.period[2])} {}
  THAW_INLINE LanesD one(LanesD from, LanesD to, int axis) const {
    const LanesD d = to - from;
    if constexpr (!periodic) return (void)axis, d;
    const LanesD half = LanesD(0.5) * period[axis];
    const LanesD none(0.0);
    // period 0: not periodic
    return select((none < half) & (half < d), d - period[axis], select((none < half) & (d < -half), d + period[axis], d));
  }
  THAW_INLINE Vec3<LanesD> operator()(const Lanes4<double>& from, const Lanes4<double>& to) const {
    return {one(from.a, to.a, 0), one(from.b, to.b, 1), one(from.c, to.c, 2)};
  }
};

struct alignas(64) Rows { std::uint32_t row[8]; };
THAW_INLINE Rows threefold(const std::uint32_t* rows) {
  Rows r;
  *reinterpret_cast<Vec8u*>(r.row) = *reinterpret_cast<const Vec8u*>(rows) * 3u;
  return r;
}
template<class Real> THAW_INLINE Vec3<Lanes<Real>> loadVector(const void* x, const void* y, const void* z, std::size_t at) {
  return {loadRow(static_cast<const Real*>(x) + at), loadRow(static_cast<const Real*>(y) + at), loadRow(static_cast<const Real*>(z) + at)};
}
template<class Real> THAW_INLINE void addOuter(Mat3<Lanes<Real>>& m, const Vec3<Lanes<Real>>& a, const Vec3<Lanes<Real>>& b) {
  for (int r = 0; r < 3; r++) {
    const Lanes<Real>& s = r == 0 ? a.x : r == 1 ? a.y : a.z;
    m.row[r].x += s * b.x;
    m.row[r].y += s * b.y;
    m.row[r].z += s * b.z;
  }
}
template<class Real> THAW_INLINE void storeMatrix(const Mat3<Lanes<Real>>& m, double out[9][8]) {
  for (int r = 0; r < 3; r++) {
    toDoubles(widen(m.row[r].x), out[3 * r]);
    toDoubles(widen(m.row[r].y), out[3 * r + 1]);
    toDoubles(widen(m.row[r].z), out[3 * r + 2]);
  }
}
template<class Real> THAW_INLINE Mat3<Lanes<Real>> loadMatrix(const double in[9][8]) {
  Mat3<Lanes<Real>> m;
  for (int r = 0; r < 3; r++) m.row[r] = {fromDoubles<Real>(in[3 * r]), fromDoubles<Real>(in[3 * r + 1]), fromDoubles<Real>(in[3 * r + 2])};
  return m;
}
template<class Real> THAW_INLINE Sym3<Lanes<Real>> loadTensor(const double in[6][8]) {
  return {fromDoubles<Real>(in[0]), fromDoubles<Real>(in[1]), fromDoubles<Real>(in[2]), fromDoubles<Real>(in[3]), fromDoubles<Real>(in[4]), fromDoubles<Real>(in[5])};
}

template<class Real, bool periodic> void deformationOf(ElasticArrays& a) {
  using T = Lanes<Real>;
  const auto* place = static_cast<const Record<Real>*>(a.place);
  const Places<Real, periodic> difference(a);
  alignas(64) double gradU[9][8], strain[6][8], plastic[6][8], stress[9][8], inverse[6][8], energy[8];
  LaneConstants c;
  T largest(Real(1));
  const T breakStretch2(static_cast<Real>(a.breakStretch2));
  for (std::size_t gi = 0; gi < a.groupCount; gi++) {
    const std::size_t g = a.groups[gi], s0 = 8 * g, base = g * a.capacity * 8;
    const int n = a.owned - s0 < 8 ? static_cast<int>(a.owned - s0) : 8;
    Rows self;
    for (int l = 0; l < 8; l++) self.row[l] = static_cast<std::uint32_t>(s0) + static_cast<std::uint32_t>(l);
    const Lanes4<Real> own = load(place, self.row);
    Mat3<T> sum{};
    T excess(Real(0));
    for (std::size_t at = base, end = base + std::size_t(a.bondCount[g]) * 8; at < end; at += 8) {
      const Vec3<T> x = difference(own, load(place, a.neighbour + at)), ref = loadVector<Real>(a.x, a.y, a.z, at);
      const T w = loadRow(static_cast<const Real*>(a.weight) + at);
      const Vec3<T> u{x.x - ref.x, x.y - ref.y, x.z - ref.z}, wRef{w * ref.x, w * ref.y, w * ref.z};
      addOuter<Real>(sum, u, wRef);
      if (a.stretched) {
        T reference = ref.x * ref.x + ref.y * ref.y + ref.z * ref.z;
        if (a.twoFrames) {
          const Vec3<T> back = loadVector<Real>(a.rx, a.ry, a.rz, at);
          reference = max(reference, back.x * back.x + back.y * back.y + back.z * back.z);
        }
        excess = max(excess, x.x * x.x + x.y * x.y + x.z * x.z - breakStretch2 * reference);
      }
    }
    if (a.stretched) a.stretched[g] = any(T(Real(0)) < excess);
    for (int l = 0; l < 8; l++) {
      const Sym3d m = l < n ? a.momentInverse[s0 + static_cast<std::size_t>(l)] : Sym3d{};
      inverse[0][l] = m.xx, inverse[1][l] = m.yy, inverse[2][l] = m.zz, inverse[3][l] = m.xy, inverse[4][l] = m.yz, inverse[5][l] = m.xz;
    }
    const Sym3<T> momentInverse = loadTensor<Real>(inverse);
    Mat3<T> gradient = times(sum, momentInverse);
    storeMatrix<Real>(gradient, gradU);
    if (a.singularLanes[g] != 0) {
      for (int l = 0; l < n; l++)
        if (a.singularLanes[g] >> l & 1) completeLane(a, s0 + static_cast<std::size_t>(l), l, gradU);
      gradient = loadMatrix<Real>(gradU);
    }
    Mat3<T> f = gradient;
    f.row[0].x += T(Real(1));
    f.row[1].y += T(Real(1));
    f.row[2].z += T(Real(1));

    loadLaneConstants(a, s0, n, c);
    const T lambda = fromDoubles<Real>(c.lambda), mu = fromDoubles<Real>(c.mu), volume = fromDoubles<Real>(c.volume);
    const Sym3<T> green = greenStrain(gradient);
    Sym3<T> plasticStrain{};
    if (a.plastic) {
      toDoubles(widen(green.xx), strain[0]), toDoubles(widen(green.yy), strain[1]), toDoubles(widen(green.zz), strain[2]);
      toDoubles(widen(green.xy), strain[3]), toDoubles(widen(green.yz), strain[4]), toDoubles(widen(green.xz), strain[5]);
      for (int l = 0; l < 8; l++) {
        if (l < n) flowLane(a, c.constants[l], s0 + static_cast<std::size_t>(l), strain, l, plastic);
        else for (int q = 0; q < 6; q++) plastic[q][l] = 0;
      }
      plasticStrain = loadTensor<Real>(plastic);
    } else {
      for (int q = 0; q < 6; q++)
        for (int l = 0; l < 8; l++) plastic[q][l] = 0;
    }

    // Which formula a lane gets depends on its own material only, never on the slots that share its group.
    Mat3<T> piola{};
    if (c.anyGreen) {
      const Sym3<T> elastic = green - plasticStrain;
      piola = greenStress(f, elastic, lambda, mu);
      if (a.energy) toDoubles(widen(greenEnergy(elastic, lambda, mu)), energy);
    }
    if (c.anyNeoHookean) {
      Mat3<T> other = neoHookeanStress(f, lambda, mu);
      if (a.plastic) other = other - times(f, hooke(plasticStrain, lambda, mu));
      const auto isOther = T(Real(0.5)) < fromDoubles<Real>(c.neoHookean);
      for (int r = 0; r < 3; r++)
        piola.row[r] = {select(isOther, other.row[r].x, piola.row[r].x), select(isOther, other.row[r].y, piola.row[r].y), select(isOther, other.row[r].z, piola.row[r].z)};
    }
    if (c.anyVolumeStiffness) {
      const T stiffness = fromDoubles<Real>(c.volumeStiffness);
      piola = piola + volumeStress(f, stiffness);
      if (a.energy && c.anyGreen) toDoubles(loadRow(energy) + widen(volumeEnergy(f, stiffness)), energy);
    }
    if (c.anyCorotated) {
      storeMatrix<Real>(piola, stress);
      for (int l = 0; l < n; l++)
        if (c.constants[l].law == ElasticLaw::Corotated) energy[l] = respondLane(c.constants[l], gradU, plastic, l, stress);
      piola = loadMatrix<Real>(stress);
    }
    if (a.energy && c.anyNeoHookean)  // a logarithm
      for (int l = 0; l < n; l++)
        if (c.constants[l].law == ElasticLaw::NeoHookean) energy[l] = respondLane(c.constants[l], gradU, plastic, l, nullptr);

    // Green strain alone weakens where it is squeezed to less than sqrt(1/3) in some direction: 3 E + 1 - (plastic strain) has an
    // eigenvalue < 0 (3/2 C - 1/2 without plastic strain), which its leading minors tell. Not where |E| < 1/3 says that it has none.
    const T three(Real(3));
    const auto squared = [](const Sym3<T>& e) { return e.xx * e.xx + e.yy * e.yy + e.zz * e.zz + T(Real(2)) * (e.xy * e.xy + e.yz * e.yz + e.xz * e.xz); };
    if (c.anyGreen && (a.plastic || any(T(Real(1) / 9) < squared(green)))) {
      const T one(Real(1));
      const T xx = three * green.xx + one - plasticStrain.xx, yy = three * green.yy + one - plasticStrain.yy, zz = three * green.zz + one - plasticStrain.zz;
      const T xy = three * green.xy - plasticStrain.xy, yz = three * green.yz - plasticStrain.yz, xz = three * green.xz - plasticStrain.xz;
      const T second = xx * yy - xy * xy, third = zz * second - xx * yz * yz - yy * xz * xz + (xy + xy) * yz * xz;
      const T least = min(xx, min(second, third));
      if (any(least < T(Real(0))))
        for (int l = 0; l < n; l++) a.squeezed += least[l] < 0 && c.constants[l].law == ElasticLaw::Green && !(c.volumeStiffness[l] > 0);
    }

    // flux = V P A^-1 - k grad u
    const Mat3<T> flux = volume * times(piola, momentInverse) - fromDoubles<Real>(c.hourglass) * gradient;
    const T j = determinant(f);
    const T size = dot(f.row[0], f.row[0]) + dot(f.row[1], f.row[1]) + dot(f.row[2], f.row[2]);
    const T stretch2 = size - T(Real(2));
    largest = max(largest, stretch2);
    if (a.groupStretch2) {
      double& most = a.groupStretch2[g] = 1;
      for (int l = 0; l < n; l++)
        if (static_cast<double>(stretch2[l]) > most) most = static_cast<double>(stretch2[l]);
    }
    alignas(64) double fluxes[9][8];
    storeMatrix<Real>(flux, fluxes);
    Real* out = static_cast<Real*>(a.flux) + 12 * s0;
    for (int l = 0; l < n; l++, out += 12) {
      const std::size_t s = s0 + static_cast<std::size_t>(l);
      for (int r = 0; r < 3; r++) {
        for (int q = 0; q < 3; q++) out[4 * r + q] = static_cast<Real>(fluxes[3 * r + q][l]);
        a.deformation[s].row[r] = {gradU[3 * r][l] + (r == 0), gradU[3 * r + 1][l] + (r == 1), gradU[3 * r + 2][l] + (r == 2)};
      }
      out[3] = static_cast<Real>(c.hourglass[l]);
      out[7] = static_cast<Real>(c.drag[l]);
      out[11] = 0;
      if (a.energy) a.energyColumn[s] = c.volume[l] * energy[l];
      if (a.remote) {
        for (int r = 0; r < 3; r++) a.fluxColumn[s].row[r] = {fluxes[3 * r][l], fluxes[3 * r + 1][l], fluxes[3 * r + 2][l]};
        a.hourglassColumn[s] = c.hourglass[l];
        if (a.damping) a.dragColumn[s] = c.drag[l];
      }
      if (!(j[l] > 0)) a.inverted++;
    }
  }
  for (int l = 0; l < 8; l++)
    if (static_cast<double>(largest[l]) > a.maxStretch2) a.maxStretch2 = static_cast<double>(largest[l]);
}

template<class Real> struct Flux { Lanes4<Real> x, y, z; };  // rows; x.d = k, y.d = drag
template<class Real> THAW_INLINE Flux<Real> loadFlux(const Record<Real>* at, const std::uint32_t* rows) {
  const Rows r = threefold(rows);
  return {load(at, r.row), load(at + 1, r.row), load(at + 2, r.row)};
}
template<class Real> THAW_INLINE Lanes<Real> rowTimes(const Lanes4<Real>& r, const Vec3<Lanes<Real>>& v) { return r.a * v.x + r.b * v.y + r.c * v.z; }

template<class Real, bool periodic, bool twoFrames> void forcesOf(const ElasticArrays& a) {
  using T = Lanes<Real>;
  const auto* place = static_cast<const Record<Real>*>(a.place);
  const auto* fluxes = static_cast<const Record<Real>*>(a.flux);
  const auto* motion = static_cast<const Record<Real>*>(a.motion);
  const Places<Real, periodic> difference(a);
  alignas(64) double out[4][8];
  for (std::size_t gi = 0; gi < a.groupCount; gi++) {
    const std::size_t g = a.groups[gi], s0 = 8 * g, base = g * a.capacity * 8;
    const int n = a.owned - s0 < 8 ? static_cast<int>(a.owned - s0) : 8;
    Rows self;
    for (int l = 0; l < 8; l++) self.row[l] = static_cast<std::uint32_t>(s0) + static_cast<std::uint32_t>(l < n ? l : 0);
    const Lanes4<Real> own = load(place, self.row);
    const Flux<Real> fi = loadFlux(fluxes, self.row);
    Lanes4<Real> vi{};
    if (a.damping) vi = load(motion, self.row);
    Mat3<T> gradient{};
    if (a.energy) {
      alignas(64) double gradU[9][8];
      for (int l = 0; l < 8; l++)
        for (int r = 0; r < 3; r++) {
          const Vec3d& row = a.deformation[self.row[l]].row[r];
          gradU[3 * r][l] = row.x - (r == 0), gradU[3 * r + 1][l] = row.y - (r == 1), gradU[3 * r + 2][l] = row.z - (r == 2);
        }
      gradient = loadMatrix<Real>(gradU);
    }
    LanesD fx(0.0), fy(0.0), fz(0.0), lost(0.0);  // sums in double: momentum is conserved to its rounding in single precision, too
    T errors(Real(0));
    for (std::size_t at = base, end = base + std::size_t(a.bondCount[g]) * 8; at < end; at += 8) {
      const std::uint32_t* rows = a.neighbour + at;
      const Vec3<T> x = difference(own, load(place, rows)), ref = loadVector<Real>(a.x, a.y, a.z, at);
      const T w = loadRow(static_cast<const Real*>(a.weight) + at);
      const Flux<Real> fj = loadFlux(fluxes, rows);
      const Vec3<T> u{x.x - ref.x, x.y - ref.y, x.z - ref.z};
      Vec3<T> t;
      if constexpr (twoFrames) {
        const Vec3<T> back = loadVector<Real>(a.rx, a.ry, a.rz, at);
        // (term of i) - (term of j): the other end computes exactly the negative
        t = {(rowTimes(fi.x, ref) + fi.x.d * u.x) - (rowTimes(fj.x, back) - fj.x.d * (x.x + back.x)),
             (rowTimes(fi.y, ref) + fi.x.d * u.y) - (rowTimes(fj.y, back) - fj.x.d * (x.y + back.y)),
             (rowTimes(fi.z, ref) + fi.x.d * u.z) - (rowTimes(fj.z, back) - fj.x.d * (x.z + back.z))};
      } else {
        const T k = fi.x.d + fj.x.d;
        t = {(fi.x.a + fj.x.a) * ref.x + (fi.x.b + fj.x.b) * ref.y + (fi.x.c + fj.x.c) * ref.z + k * u.x,
             (fi.y.a + fj.y.a) * ref.x + (fi.y.b + fj.y.b) * ref.y + (fi.y.c + fj.y.c) * ref.z + k * u.y,
             (fi.z.a + fj.z.a) * ref.x + (fi.z.b + fj.z.b) * ref.y + (fi.z.c + fj.z.c) * ref.z + k * u.z};
      }
      if (a.damping) {
        const Lanes4<Real> vj = load(motion, rows);
        const T square = x.x * x.x + x.y * x.y + x.z * x.z, some = select(square > T(Real(0)), square, T(Real(1)));
        const T along = (vj.a - vi.a) * x.x + (vj.b - vi.b) * x.y + (vj.c - vi.c) * x.z;
        const T c = (fi.y.d + fj.y.d) * along / some;  // per weight
        t = {t.x + c * x.x, t.y + c * x.y, t.z + c * x.z};
        lost += wide(w * c * along);
      }
      if (a.energy) {
        const Vec3<T> e{u.x - dot(gradient.row[0], ref), u.y - dot(gradient.row[1], ref), u.z - dot(gradient.row[2], ref)};
        errors += w * (e.x * e.x + e.y * e.y + e.z * e.z);
      }
      fx += wide(w * t.x);
      fy += wide(w * t.y);
      fz += wide(w * t.z);
    }
    toDoubles(fx, out[0]), toDoubles(fy, out[1]), toDoubles(fz, out[2]), toDoubles(lost, out[3]);
    for (int l = 0; l < n; l++) a.force[s0 + static_cast<std::size_t>(l)] = {out[0][l], out[1][l], out[2][l]};
    if (a.damping)
      for (int l = 0; l < n; l++) a.dissipated[s0 + static_cast<std::size_t>(l)] += 0.5 * out[3][l] * a.dt;  // half of each bond at each end
    if (a.energy)
      for (int l = 0; l < n; l++) a.energyColumn[s0 + static_cast<std::size_t>(l)] += 0.5 * static_cast<double>(fi.x.d[l]) * static_cast<double>(errors[l]);
  }
}

void deformation(ElasticArrays& a) {
  if (a.precision == Precision::Single) return a.periodic ? deformationOf<float, true>(a) : deformationOf<float, false>(a);
  return a.periodic ? deformationOf<double, true>(a) : deformationOf<double, false>(a);
}
void forces(const ElasticArrays& a) {
  if (a.precision == Precision::Single) {
    if (a.twoFrames) return a.periodic ? forcesOf<float, true, true>(a) : forcesOf<float, false, true>(a);
    return a.periodic ? forcesOf<float, true, false>(a) : forcesOf<float, false, false>(a);
  }
  if (a.twoFrames) return a.periodic ? forcesOf<double, true, true>(a) : forcesOf<double, false, true>(a);
  return a.periodic ? forcesOf<double, true, false>(a) : forcesOf<double, false, false>(a);
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
