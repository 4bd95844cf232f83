// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/laws/crease_pair.hpp"

#include <algorithm>

namespace thaw {

PairResult creasedPair(const PairPotential& p, const Vec3d& r, const Vec3d& ni, const Vec3d& nj,
                       bool iCreased, bool jCreased) {
  PairPotential radial = p;
  radial.facing = false;
  PairResult out = pairForces(radial, r, ni, nj, {false});
  const double r2 = dot(r, r), far = std::sqrt(r2);
  if (!(far < p.reach) || !(far > 0)) return out;
  const Ramp inside = smoothRamp((p.reach - far) / (p.reach - p.fade));
  const double s2 = 1 / (p.spacing * p.spacing), across = 1 / (p.a * p.a), deep = 1 / (p.b * p.b),
               follow = 0.1 * p.normal;
  const double h[2] = {dot(ni, r), dot(nj, r)};
  double psi[2];
  for (int k = 0; k < 2; k++) psi[k] = std::exp(-0.5 * ((r2 - h[k] * h[k]) * across + h[k] * h[k] * deep));
  const double apart = 2 - 2 * dot(ni, nj),
               weight[2] = {(iCreased ? 0.0 : p.plane) * s2 * h[0] * h[0] + 0.5 * follow * apart,
                            (jCreased ? 0.0 : p.plane) * s2 * h[1] * h[1] + 0.5 * follow * apart};
  const double energy = weight[0] * psi[0] + weight[1] * psi[1];
  const double byRadius = -(weight[0] * psi[0] + weight[1] * psi[1]) * across;
  const double byI = (iCreased ? 0.0 : 2 * p.plane) * s2 * h[0] * psi[0] +
                     weight[0] * psi[0] * (across - deep) * h[0];
  const double byJ = (jCreased ? 0.0 : 2 * p.plane) * s2 * h[1] * psi[1] +
                     weight[1] * psi[1] * (across - deep) * h[1];
  const double share = p.scale * inside.value;
  out.energy += share * energy;
  out.force += share * (byRadius * r + byI * ni + byJ * nj) -
               (p.scale * inside.slope * energy / ((p.reach - p.fade) * far)) * r;
  out.torque -= share * cross(ni, byI * r - (follow * (psi[0] + psi[1])) * nj);
  const double most = std::max(psi[0], psi[1]);
  out.stiffness += share * (2 * p.plane * s2 * most + energy / (p.b * p.b));
  out.turnStiffness += share * (2 * p.plane * r2 * s2 + 2 * follow) * most;
  return out;
}

}  // namespace thaw
