// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/laws/pair_potential.hpp"

#include <algorithm>

namespace thaw {
namespace {

double power(double x, int n) {
  double result = 1;
  for (; n > 0; n >>= 1, x *= x)
    if (n & 1) result *= x;
  return result;
}

/// Weight exp(-(r^2 - h^2)/(2 a^2) - h^2/(2 b^2)) with height h = n . r, and its derivatives.
struct Weight {
  double value, perPlace, perHeight;
};  // d psi = psi (perPlace r . dr + perHeight h dh)

Weight weightOf(const PairPotential& p, double r2, double h) {
  const double across = 1 / (p.a * p.a), along = 1 / (p.b * p.b);
  return {std::exp(-0.5 * ((r2 - h * h) * across + h * h * along)), -across, across - along};
}

}  // namespace

RadialPart radialPart(const PairPotential& p, double r) {
  const double at = std::max(r, p.core), q = p.well / at, share = 1.0 / (p.n - p.m);
  const double repel = p.m * power(q, p.n) * share, attract = p.n * power(q, p.m) * share;
  RadialPart part{repel - attract, (p.m * attract - p.n * repel) / at,
                  (p.n * (p.n + 1) * repel - p.m * (p.m + 1) * attract) / (at * at)};
  if (r < p.core) {
    part.energy += part.slope * (r - p.core);
    part.curvature = 0;
  }
  return part;
}

PairResult pairForces(const PairPotential& p, const Vec3d& r, const Vec3d& ni, const Vec3d& nj,
                      PairKind kind) {
  PairResult out;
  const double r2 = dot(r, r);
  if (!(r2 < p.reach * p.reach) || !(r2 > 0)) return out;
  const double length = std::sqrt(r2), cosine = dot(ni, nj);
  const Ramp face = p.facing ? smoothRamp(2 * cosine) : Ramp{1, 0};
  if (face.value == 0) return out;
  const Ramp inside = smoothRamp((p.reach - length) / (p.reach - p.fade));
  const RadialPart radial = radialPart(p, length);
  double energy = p.attract * radial.energy;
  // dE/dr and dE/dn_i without the factors fade, face and scale
  Vec3d byPlace = (p.attract * radial.slope / length) * r, byNormal{};
  double stiff = p.attract * std::max(std::abs(radial.curvature), std::abs(radial.slope) / length), turn = 0;
  if (kind.oriented) {
    const double s2 = 1 / (p.spacing * p.spacing);
    const double hi = dot(ni, r), hj = dot(nj, r), both = hi + hj;
    const Weight wi = weightOf(p, r2, hi), wj = weightOf(p, r2, hj);
    // |n_i - n_j|^2 for unit normals
    const double mean = 0.5 * (wi.value + wj.value), apart = 2 - 2 * cosine;
    const double rest = p.normal * apart + p.circle * both * both * s2;
    // factors of psi_i and psi_j
    const double ei = p.plane * hi * hi * s2 + 0.5 * rest, ej = p.plane * hj * hj * s2 + 0.5 * rest;
    energy += ei * wi.value + ej * wj.value;
    const double byHi = 2 * p.plane * hi * s2 * wi.value + ei * wi.value * wi.perHeight * hi +
                        2 * p.circle * both * s2 * mean;
    const double byHj = 2 * p.plane * hj * s2 * wj.value + ej * wj.value * wj.perHeight * hj +
                        2 * p.circle * both * s2 * mean;
    const double byRadius = ei * wi.value * wi.perPlace + ej * wj.value * wj.perPlace;
    byPlace += byRadius * r + byHi * ni + byHj * nj;
    byNormal = byHi * r - (2 * p.normal * mean) * nj;
    const double most = std::max(wi.value, wj.value);
    stiff += (2 * p.plane + 8 * p.circle) * s2 * most + rest * most / (p.b * p.b);
    turn = (2 * p.plane + 2 * p.circle) * r2 * s2 * most + 2 * p.normal * most;
  }
  const double share = p.scale * inside.value * face.value;
  out.energy = share * energy;
  // dE/dr = -dE/dx_i
  out.force = share * byPlace -
              (p.scale * face.value * inside.slope * energy / ((p.reach - p.fade) * length)) * r;
  byNormal = share * byNormal + (p.facing ? p.scale * inside.value * 2 * face.slope * energy : 0.0) * nj;
  out.torque = -cross(ni, byNormal);
  out.stiffness = share * stiff;
  out.turnStiffness = share * turn;
  return out;
}

LatticeEnergy hexagonalEnergy(const PairPotential& p, double spacing) {
  LatticeEnergy sum{0, 0};
  const int most = static_cast<int>(p.reach / (0.86 * spacing)) + 1;
  for (int i = -most; i <= most; i++)
    for (int k = -most; k <= most; k++) {
      // squared distance in the lattice, over spacing^2
      const double far = std::sqrt(static_cast<double>(i * i + i * k + k * k)), r = far * spacing;
      if (far == 0 || r >= p.reach) continue;
      const RadialPart radial = radialPart(p, r);
      const Ramp inside = smoothRamp((p.reach - r) / (p.reach - p.fade));
      sum.energy += 0.5 * p.scale * p.attract * inside.value * radial.energy;
      sum.slope += 0.5 * p.scale * p.attract * far *
                   (inside.value * radial.slope - inside.slope / (p.reach - p.fade) * radial.energy);
    }
  return sum;
}

PairPotential pairPotential(const OrientedBody& body, double spacing) {
  PairPotential p;
  p.spacing = spacing;
  p.reach = body.support * spacing;
  p.fade = 0.75 * p.reach;
  p.scale = body.stiffness * spacing * spacing;
  p.n = static_cast<int>(body.repelPower);
  p.m = static_cast<int>(body.attractPower);
  p.attract = body.attract;
  p.plane = body.plane;
  p.normal = body.normal;
  p.circle = body.circle;
  p.a = body.across * spacing;
  p.b = body.along * spacing;
  p.facing = body.facing;
  p.core = body.core * spacing;
  p.well = spacing;
  if (body.source == OrientedSource::Curve || !(p.attract > 0)) return p;
  // Bisection finds the zero of the lattice's slope. A fixed number of iterations gives the same bits on all
  // ranks. If the well is too small, the lattice contracts (slope > 0).
  double low = 0.8 * spacing, high = 1.6 * spacing;
  for (int k = 0; k < 100; k++) {
    p.well = 0.5 * (low + high);
    (hexagonalEnergy(p, spacing).slope > 0 ? low : high) = p.well;
  }
  return p;
}

}  // namespace thaw
