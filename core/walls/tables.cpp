// SPDX-License-Identifier: Apache-2.0
#include "core/walls/tables.hpp"

#include <algorithm>
#include <array>

#include "core/kernels/lattice.hpp"
#include "core/kernels/viscous_weight.hpp"
#include "core/kernels/with_kernel.hpp"

namespace thaw {
namespace {

struct Plane {
  double w = 0, slope = 0, laplace = 0, drag = 0;
};

/// Integrals over a plane at distance z: W, -dW/dz, the Laplacian's kernel, and the viscous weight times
/// x^2/r^2, x along the plane. The first three times s = |r| are polynomials of degree at most 7 on either
/// side of 1/2. The five-point Gauss rule is exact for them.
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
      p.drag += ring * isa_base::alongPair(viscousScale, s * s) * (s * s - z * z) / (2 * s * s);
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
    sum.drag += spacing * (n.viscosity == ViscosityForm::Laplacian ? p.laplace : p.drag) * (1 + depth / from);
  }
  return sum;
}

WallIntegrals rawIntegrals(const Numerics& n, double d) {
  constexpr double scale = ViscousWeight{}.scale;  // continuum scale; perShearStress scales the drag
  return withKernel(n.kernel, [&](auto kernel) { return integralsOf<decltype(kernel)>(n, scale, d); });
}

/// Inverse of the total drag on layers half a spacing and whole spacings above a wall, in a linear profile,
/// per mu du/dz.
double perShearStress(const Numerics& n) {
  const double spacing = 1 / n.support;
  double stress = 0;
  for (double d = 0.5 * spacing; d < 1; d += spacing) stress += spacing * rawIntegrals(n, d).drag * d;
  return stress > 0 ? 1 / stress : 1;
}

template<class Kernel> double secondMoment(double spacing) {
  double sum = 0;
  // Half of the moment; the other half comes from the other side.
  for (double z = spacing; z < 1; z += spacing) sum += spacing * planeAt<Kernel>(z, 0).laplace * z * z;
  return sum;
}

/// Inverse of the second derivative of a temperature as seen by a sum over layers on both sides; 1 for plain
/// conduction.
double perConduction(const Numerics& n) {
  if (conductionScale(n) == 1) return 1;
  return withKernel(n.kernel, [&](auto kernel) { return 1 / secondMoment<decltype(kernel)>(1 / n.support); });
}

WallIntegrals scaled(WallIntegrals w, double drag, double conduct) {
  w.drag *= drag;
  w.conduct *= conduct;
  return w;
}

}  // namespace

WallIntegrals wallIntegrals(const Numerics& n, double d) {
  return scaled(rawIntegrals(n, d), perShearStress(n), perConduction(n));
}

WallIntegrals forLiquids(const WallIntegrals& w, double onLattice) {
  WallIntegrals liquid = w;
  liquid.space = w.relativeDensity;
  if (onLattice > 0)
    liquid.relativeDensity = w.relativeDensity * w.relativeDensity / onLattice,
    liquid.push = w.push * 2 * w.relativeDensity / onLattice;
  return liquid;
}

WallTables makeWallTables(const Numerics& n) {
  const double spacing = 1 / n.support, drag = perShearStress(n), conduct = perConduction(n);
  WallTables t;
  t.lowest = -0.5 * spacing;
  t.nearest = 0.25 * spacing;
  const double onLattice = rawIntegrals(n, 0.5 * spacing).relativeDensity, softFrom = softBelow * spacing;
  const WallIntegrals soft = forLiquids(rawIntegrals(n, softFrom), onLattice);
  for (int k = 0; k <= WallTables::points; k++) {
    const double d = t.lowest + (1 - t.lowest) * k / WallTables::points;
    t.at.push_back(forLiquids(scaled(rawIntegrals(n, d), drag, conduct), onLattice));
    if (d < softFrom)
      t.at.back().relativeDensity = soft.relativeDensity + soft.push * (softFrom - d),
      t.at.back().push = soft.push;
  }
  return t;
}

}  // namespace thaw
