// SPDX-License-Identifier: Apache-2.0
#include "core/walls/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/kernels/lattice.hpp"
#include "core/kernels/viscous_weight.hpp"
#include "core/kernels/with_kernel.hpp"

namespace thaw {
namespace {

struct Plane {
  double w = 0, slope = 0, laplace = 0, drag = 0, shear = 0;
};

/// Integrals over a plane at distance z (h). The integrands are W, -dW/dz, the Laplacian's kernel, and the
/// viscous weight times x^2/r^2 and x^2 z^2/r^2. Here x is along the plane. On either side of s = 1/2, the
/// first three integrands times s = |r| are polynomials of degree at most 7. The five-point Gauss rule is
/// exact for these.
template<class Kernel> Plane planeAt(double z, double viscousScale) {
  constexpr std::array<double, 5> node{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                       0.9061798459386640};
  constexpr std::array<double, 5> weight{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                         0.4786286704993665, 0.2369268850561891};
  Plane p;
  const auto addPart = [&](double from, double to) {
    const double half = 0.5 * (to - from);
    for (std::size_t k = 0; k < node.size(); k++) {
      const double s = from + half * (1 + node[k]), ring = 2 * isa_base::pi * s * half * weight[k];
      p.w += ring * Kernel::w(s * s);
      p.slope -= ring * z * Kernel::slope(s * s);
      p.laplace += ring * Kernel::laplace(s * s);
      const double along = ring * isa_base::alongPair(viscousScale, s * s) * (s * s - z * z) / (2 * s * s);
      p.drag += along;
      p.shear += along * z * z;
    }
  };
  if (z < 0.5) addPart(z, 0.5);
  if (z < 1) addPart(std::max(z, 0.5), 1);
  return p;
}

template<class Kernel> WallIntegrals integralsOf(const Numerics& n, double viscousScale, double d) {
  const double spacing = 1 / n.support;
  WallIntegrals sum;
  const double from = std::max(d, 0.25 * spacing);
  for (double depth = 0.5 * spacing; d + depth < 1; depth += spacing) {
    const Plane p = planeAt<Kernel>(d + depth, viscousScale);
    sum.relativeDensity += spacing * p.w;
    sum.push += spacing * p.slope;
    sum.momentShare += spacing * p.slope * (d + depth);
    sum.conduct += spacing * p.laplace * (1 + depth / from);
    sum.shear += spacing * p.shear;
    sum.drag += spacing * (n.viscosity == ViscosityForm::Laplacian ? p.laplace : p.drag) * (1 + depth / from);
  }
  return sum;
}

WallIntegrals rawIntegrals(const Numerics& n, double d) {
  constexpr double scale = ViscousWeight{}.scale;  // any scale will do, since dragAt scales the drag
  return withKernel(n.kernel, [&](auto kernel) { return integralsOf<decltype(kernel)>(n, scale, d); });
}

/// Stress of the raw drag on a layer at the distance d (h) in a linear velocity profile, in an arbitrary
/// unit.
double rawStress(const Numerics& n, double d) { return rawIntegrals(n, d).drag * d; }

/// Share of the wall's shear stress that acts on a layer at the distance d (h). The shares of layers at
/// distances of one spacing add up to 1 for any position of the first layer. Otherwise liquid whose first
/// layer is nearly a spacing from the wall would slip. First layers closer than `nearest` occur only in
/// impacts. For these, the shares of the layers behind vary linearly, so the share of a layer that approaches
/// from outside is continuous.
double shareOfStress(const Numerics& n, double d) {
  constexpr double nearest = 0.4;  // spacings
  const double spacing = 1 / n.support, layer = std::floor(d * n.support), part = d * n.support - layer;
  if (!(d > 0 && d < 1)) return 0;
  if (part < nearest) {
    const auto between = [&](double k) {
      const double to = std::min(nearest, n.support - k), before = shareOfStress(n, (k - 1e-9) * spacing),
                   after = shareOfStress(n, (k + to + 1e-9) * spacing);
      return before + (after - before) * part / to;
    };
    if (layer > 0) return between(layer);
    double behind = 0;
    for (double k = 1; (k + part) * spacing < 1; k++) behind += between(k);
    return 1 - behind;
  }
  double whole = 0;
  for (double other = part * spacing; other < 1; other += spacing) whole += rawStress(n, other);
  return whole > 0 ? rawStress(n, d) / whole : layer == 0 ? 1 : 0;
}

/// Drag (WallIntegrals::drag): the share of the stress divided by the velocity. Inside the wall it has its
/// value at the surface.
double dragAt(const Numerics& n, double d) {
  const double spacing = 1 / n.support, least = 0.05 * spacing, at = std::max(d, least);
  return shareOfStress(n, at) / (spacing * at);
}

template<class Kernel> double secondMoment(double spacing) {
  double sum = 0;
  // Half of the moment; the other half comes from the other side.
  for (double z = spacing; z < 1; z += spacing) sum += spacing * planeAt<Kernel>(z, 0).laplace * z * z;
  return sum;
}

/// Inverse of the second derivative that a sum over layers on both sides gives for a temperature. It is 1 for
/// plain conduction.
double perConduction(const Numerics& n) {
  if (conductionScale(n) == 1) return 1;
  return withKernel(n.kernel, [&](auto kernel) { return 1 / secondMoment<decltype(kernel)>(1 / n.support); });
}

WallIntegrals scaledAt(const Numerics& n, double d, double conduct) {
  WallIntegrals w = rawIntegrals(n, d);
  w.drag = dragAt(n, d);
  w.conduct *= conduct;
  w.shear /= 2 * rawIntegrals(n, 0.5 / n.support).shear;  // layers on both sides
  return w;
}

}  // namespace

WallIntegrals wallIntegrals(const Numerics& n, double d) { return scaledAt(n, d, perConduction(n)); }

WallIntegrals forLiquids(const WallIntegrals& w, double onLattice) {
  WallIntegrals liquid = w;
  liquid.space = w.relativeDensity;
  if (onLattice > 0)
    liquid.relativeDensity = w.relativeDensity * w.relativeDensity / onLattice,
    liquid.push = w.push * 2 * w.relativeDensity / onLattice;
  return liquid;
}

WallTables makeWallTables(const Numerics& n) {
  const double spacing = 1 / n.support, conduct = perConduction(n);
  WallTables t;
  t.lowest = -0.5 * spacing;
  t.nearest = 0.25 * spacing;
  const double onLattice = rawIntegrals(n, 0.5 * spacing).relativeDensity, softFrom = softBelow * spacing;
  const WallIntegrals soft = forLiquids(rawIntegrals(n, softFrom), onLattice);
  for (int k = 0; k <= WallTables::points; k++) {
    const double d = t.lowest + (1 - t.lowest) * k / WallTables::points;
    t.at.push_back(forLiquids(scaledAt(n, d, conduct), onLattice));
    if (d < softFrom)
      t.at.back().relativeDensity = soft.relativeDensity + soft.push * (softFrom - d),
      t.at.back().push = soft.push;
  }
  return t;
}

}  // namespace thaw
