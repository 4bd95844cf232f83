// SPDX-License-Identifier: Apache-2.0
// The loop over bonds that computes deformation and stress. Each lane is a solid and sums its bonds in order.
// The library compiles the loop with its own laws, an extension with one of its laws. Only code that is
// compiled per instruction set includes this.
#pragma once
#include "core/solid/elasticity/law_lanes.hpp"
#include "core/solid/laws/green.hpp"
#include "core/solid/laws/volume.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Adds w u (x) X of bonds [at, end) to sum. tears: excess becomes the maximum of x^2 - stretch2 X^2, which
/// is > 0 if a bond may break.
template<bool tears, class Real, bool periodic, bool vectors>
THAW_INLINE void sumGradient(const BondLoader<Real, periodic, vectors>& bonds, std::size_t at,
                             std::size_t end, const Lanes<Real>& stretch2, Mat3<Lanes<Real>>& sum,
                             Lanes<Real>& excess) {
  const ElasticArrays& a = bonds.a;
  // Local rows stay in registers, while the matrix itself would stay in memory.
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

template<class Laws, class Real, bool periodic, bool vectors>
__attribute__((flatten)) void deformationOf(ElasticArrays& a) {
  using T = Lanes<Real>;
  BondLoader<Real, periodic, vectors> bonds(a);
  const T scale2(static_cast<Real>(bonds.scale() * bonds.scale()));
  alignas(64) double gradU[9][8], inverse[6][8], energy[8], more[8];
  LaneConstants c;
  alignas(64) PlasticLanes plastic;
  T largest(Real(1));
  const T breakStretch2(static_cast<Real>(a.breakStretch2));
  const Sym3d none{};
  for (std::size_t gi = 0; gi < a.groupCount; gi++) {
    const std::size_t g = a.groups[gi], s0 = 8 * g, base = g * a.capacity * 8;
    const int n = a.owned - s0 < 8 ? static_cast<int>(a.owned - s0) : 8;
    // Data that is written lane by lane and read as vectors is stored before the loop, to avoid
    // store-forwarding stalls.
    loadLaneConstants(a, s0, n, c);
    for (int l = 0; l < 8; l++) {
      // a pointer, since compilers copy a conditional value through memory
      const Sym3d* m = l < n ? a.momentInverse + s0 + l : &none;
      inverse[0][l] = m->xx, inverse[1][l] = m->yy, inverse[2][l] = m->zz, inverse[3][l] = m->xy,
      inverse[4][l] = m->yz, inverse[5][l] = m->xz;
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
    const unsigned softened = respond<Laws, Real>(c, {c.lambda, c.mu, elasticGradient, fe, a.energy}, piola,
                                                  energy);
    for (int l = 0; softened != 0 && l < n; l++)
      a.softenedParticles += (softened >> l & 1) && c.active[l] > 0 && !(c.volumeStiffness[l] > 0);
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

template<class Laws, class Real, bool periodic> void deformationIn(ElasticArrays& a) {
  a.vectors ? deformationOf<Laws, Real, periodic, true>(a) : deformationOf<Laws, Real, periodic, false>(a);
}
/// Runs the bond loop with these laws inlined (law_lanes.hpp).
template<class Laws> void deformation(ElasticArrays& a) {
  if (a.precision == Precision::Single)
    return a.periodic ? deformationIn<Laws, float, true>(a) : deformationIn<Laws, float, false>(a);
  return a.periodic ? deformationIn<Laws, double, true>(a) : deformationIn<Laws, double, false>(a);
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
