#include "core/walls/tables.hpp"

#include <algorithm>

#include "core/kernels/kernels.hpp"

namespace thaw {
namespace {

/// Integrals over a plane at distance z: of W, of -dW/dz and of the Laplacian's kernel. Midpoint rule over the radius s = |r|.
struct Plane { double w = 0, slope = 0, laplace = 0; };
template<class Kernel> Plane planeAt(double z) {
  constexpr int n = 1000;
  Plane p;
  if (z >= 1) return p;
  const double ds = (1 - z) / n;
  for (int k = 0; k < n; k++) {
    const double s = z + (k + 0.5) * ds, ring = 2 * isa_base::pi * s * ds;
    p.w += ring * Kernel::w(s * s);
    p.laplace += ring * Kernel::laplace(s * s);
  }
  p.slope = 2 * isa_base::pi * z * Kernel::w(z * z);
  return p;
}

template<class Kernel> WallTables tablesOf(double spacing) {
  WallTables t;
  t.lowest = -0.5 * spacing;
  t.nearest = 0.25 * spacing;
  for (int k = 0; k <= WallTables::points; k++) {
    const double d = t.lowest + (1 - t.lowest) * k / WallTables::points;
    WallIntegrals sum;
    for (double depth = 0.5 * spacing; d + depth < 1; depth += spacing) {
      const Plane p = planeAt<Kernel>(d + depth);
      sum.filling += spacing * p.w;
      sum.push += spacing * p.slope;
      sum.drag += spacing * p.laplace * (1 + depth / std::max(d, t.nearest));
    }
    t.at.push_back(sum);
  }
  return t;
}

}  // namespace

WallTables makeWallTables(KernelKind kernel, double spacing) {
  switch (kernel) {
    case KernelKind::Mcg03: return tablesOf<isa_base::Mcg03>(spacing);
    case KernelKind::CubicSpline: return tablesOf<isa_base::CubicSpline>(spacing);
    default: return tablesOf<isa_base::WendlandC2>(spacing);
  }
}

}  // namespace thaw
