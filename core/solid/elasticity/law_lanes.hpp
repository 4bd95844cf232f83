// SPDX-License-Identifier: Apache-2.0
// Laws of eight slots in double precision: corotated stress and energy, where F - R of small strains cancels,
// and the Neo-Hookean energy. Only code for one instruction set includes this.
#pragma once
#include "core/solid/elasticity/elastic_lanes.hpp"
#include "core/solid/laws/corotated.hpp"
#include "core/solid/laws/green.hpp"

namespace thaw {
namespace THAW_ISA {

THAW_INLINE Mat3<LanesD> select(MaskD m, const Mat3<LanesD>& a, const Mat3<LanesD>& b) {
  Mat3<LanesD> r;
  for (int k = 0; k < 3; k++)
    r.row[k] = {select(m, a.row[k].x, b.row[k].x), select(m, a.row[k].y, b.row[k].y),
                select(m, a.row[k].z, b.row[k].z)};
  return r;
}

/// nearestRotation() of eight F by Newton's iteration. Each lane stops independently, so its bits do not
/// depend on its group.
struct Rotations {
  Mat3<LanesD> r;
  MaskD found;  ///< false where the iteration does not apply: nearly singular or inverted F
};
THAW_INLINE Rotations nearestRotations(const Mat3<LanesD>& f) {
  const LanesD size = doubleDot(f, f) / LanesD(3.0);
  const MaskD usable = determinant(f) > LanesD(newtonsShare) * size * sqrt(size);
  Rotations out{select(usable, f, identity3<LanesD>()), {}};
  MaskD going = usable;
  for (int n = 0; n < newtonsSteps && any(going); n++) {
    const Mat3<LanesD> next = towardsRotation(out.r), change = next - out.r;
    out.r = select(going, next, out.r);
    going = going & (doubleDot(change, change) > LanesD(newtonsEnd));
  }
  out.found = {usable.lo & ~going.lo, usable.hi & ~going.hi};
  return out;
}

/// A group of slots and the requested results.
struct LawLanes {
  const LaneConstants& c;
  int n;  ///< lanes in use
  bool wantEnergy;
};
THAW_INLINE Mat3<LanesD> plusOne(Mat3<LanesD> f) {
  f.row[0].x += LanesD(1.0);
  f.row[1].y += LanesD(1.0);
  f.row[2].z += LanesD(1.0);
  return f;
}
/// Sets the energy density (Pa) of lanes with the Neo-Hookean law, as elasticResponse() without the volume
/// force. Other lanes stay.
THAW_INLINE void addNeoHookeanEnergy(const LawLanes& g, const Mat3<LanesD>& gradU, double energy[8]) {
  const Mat3<LanesD> f = plusOne(gradU);
  const LanesD lambda = loadRow(g.c.lambda), mu = loadRow(g.c.mu);
  alignas(64) double logs[8];
  toDoubles(neoHookeanLogged(f), logs);
  takeLogarithms(logs);
  const LanesD psi = neoHookeanEnergy(f, lambda, mu, loadRow(logs));
  toDoubles(select(loadRow(g.c.neoHookean) > LanesD(0.5), psi, loadRow(energy)), energy);
}

/// As above for lanes with the corotated law: stress as [row][column][lane] and, if requested, energy
/// density.
THAW_INLINE void respondCorotated(const LawLanes& g, const Mat3<LanesD>& gradU, double stress[9][8],
                                  double energy[8]) {
  const Mat3<LanesD> f = plusOne(gradU);
  const LanesD lambda = loadRow(g.c.lambda), mu = loadRow(g.c.mu);
  const MaskD ours = loadRow(g.c.corotated) > LanesD(0.5);
  const Rotations rotation = nearestRotations(f);
  const Mat3<LanesD> piola = corotatedStress(f, rotation.r, lambda, mu);
  LanesD psi(0.0);
  if (g.wantEnergy) psi = corotatedEnergy(f, rotation.r, lambda, mu);
  storeMatrix<double>(select(ours, piola, loadMatrix<double>(stress)), stress);
  if (g.wantEnergy) toDoubles(select(ours, psi, loadRow(energy)), energy);
  const MaskD hard{ours.lo & ~rotation.found.lo, ours.hi & ~rotation.found.hi};
  if (!any(hard)) return;
  alignas(64) double gradient[9][8];
  storeMatrix<double>(gradU, gradient);
  for (int l = 0; l < g.n; l++)
    if (laneOf(hard, l)) {
      ElasticConstants one = g.c.constants[l];
      one.volume = 0;
      energy[l] = respondLane(one, gradient, l, stress);
    }
}

}  // namespace THAW_ISA
}  // namespace thaw
