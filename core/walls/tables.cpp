#include "core/walls/tables.hpp"

#include <algorithm>
#include <array>

#include "core/kernels/kernels.hpp"

namespace thaw {
namespace {

struct Plane { double w = 0, slope = 0, laplace = 0; };

/// Integrals over a plane at distance z: of W, of -dW/dz and of the Laplacian's kernel. The kernels times s = |r| are polynomials of
/// degree 7 at most, on either side of 1/2, for which Gauss' rule with five points is exact.
template<class Kernel> Plane planeAt(double z) {
  constexpr std::array<double, 5> node{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 5> weight{0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  Plane p;
  const auto addPart = [&](double from, double to) {
    const double half = 0.5 * (to - from);
    for (std::size_t k = 0; k < node.size(); k++) {
      const double s = from + half * (1 + node[k]), ring = 2 * isa_base::pi * s * half * weight[k];
      p.w += ring * Kernel::w(s * s);
      p.slope -= ring * z * Kernel::slope(s * s);
      p.laplace += ring * Kernel::laplace(s * s);
    }
  };
  if (z < 0.5) addPart(z, 0.5);
  if (z < 1) addPart(std::max(z, 0.5), 1);
  return p;
}

template<class Kernel> WallIntegrals integralsOf(double spacing, double d) {
  WallIntegrals sum;
  const double from = std::max(d, 0.25 * spacing);
  for (double depth = 0.5 * spacing; d + depth < 1; depth += spacing) {
    const Plane p = planeAt<Kernel>(d + depth);
    sum.filling += spacing * p.w;
    sum.push += spacing * p.slope;
    sum.drag += spacing * p.laplace * (1 + depth / from);
  }
  return sum;
}

template<class Kernel> double secondMoment(double spacing) {
  double sum = 0;
  for (double z = spacing; z < 1; z += spacing) sum += spacing * planeAt<Kernel>(z).laplace * z * z;  // half of it, from two sides
  return sum;
}

}  // namespace

double planeLaplacian(KernelKind kernel, double spacing) {
  switch (kernel) {
    case KernelKind::Mcg03: return secondMoment<isa_base::Mcg03>(spacing);
    case KernelKind::CubicSpline: return secondMoment<isa_base::CubicSpline>(spacing);
    default: return secondMoment<isa_base::WendlandC2>(spacing);
  }
}

WallIntegrals wallIntegrals(KernelKind kernel, double spacing, double d) {
  switch (kernel) {
    case KernelKind::Mcg03: return integralsOf<isa_base::Mcg03>(spacing, d);
    case KernelKind::CubicSpline: return integralsOf<isa_base::CubicSpline>(spacing, d);
    default: return integralsOf<isa_base::WendlandC2>(spacing, d);
  }
}

WallIntegrals asLiquidsFeelIt(const WallIntegrals& w, double filling0) {
  if (!(filling0 > 0)) return {w.filling, w.push, w.drag, w.filling};
  return {w.filling * w.filling / filling0, w.push * 2 * w.filling / filling0, w.drag, w.filling};
}

WallTables makeWallTables(KernelKind kernel, double spacing) {
  WallTables t;
  t.lowest = -0.5 * spacing;
  t.nearest = 0.25 * spacing;
  const double filling0 = wallIntegrals(kernel, spacing, 0.5 * spacing).filling;
  for (int k = 0; k <= WallTables::points; k++)
    t.at.push_back(asLiquidsFeelIt(wallIntegrals(kernel, spacing, t.lowest + (1 - t.lowest) * k / WallTables::points), filling0));
  return t;
}

}  // namespace thaw
