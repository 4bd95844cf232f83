#include "core/walls/tables.hpp"

#include <algorithm>

#include "core/kernels/kernels.hpp"

namespace thaw {
namespace {

/// Integrals over the cap beyond distance d. A shell of radius s has the part 2 pi s^2 (1 - d/s) of its area in the cap; the mean of
/// 1 + z/d there is (s/d)(1 + d/s)/2. Midpoint rule.
template<class Kernel> WallIntegrals cap(double d, double dragDistance) {
  constexpr int n = 4000;
  WallIntegrals sum;
  const double ds = (1 - d) / n;
  for (int k = 0; k < n; k++) {
    const double s = d + (k + 0.5) * ds, w = Kernel::w(s * s);
    sum.filling += ds * w * 2 * isa_base::pi * s * (s - d);
    sum.push += ds * w * 2 * isa_base::pi * s;
    sum.drag += ds * Kernel::laplace(s * s) * isa_base::pi * s * (s * s - d * d) / dragDistance;
  }
  return sum;
}

template<class Kernel> WallTables tablesOf(double spacing) {
  WallTables t;
  t.nearest = 0.25 * spacing;
  for (int k = 0; k <= WallTables::points; k++) {
    const double d = static_cast<double>(k) / WallTables::points;
    t.at.push_back(cap<Kernel>(d, std::max(d, t.nearest)));
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
