#include "core/fluid/surface_stress.hpp"

#include <algorithm>
#include <cmath>

#include "core/kernels/kernels.hpp"

namespace thaw {
namespace {

constexpr double holdingTogether = 0.5, madeUp = 0.7;  // see surface_stress.hpp

/// Area per volume that a particle's gradient (|g| h) tells, but for surfaceAreaScale. As the root of 1 / |g|: it is more for convex surfaces,
/// whose tension would be too large (measured, see surface_stress.hpp).
double areaOf(double gradient) { return gradient > 0 ? surfaceShare(gradient) / std::sqrt(gradient) : 0; }

template<class Kernel> double scaleOf(double spacing) {
  double sum = 0;
  const int n = static_cast<int>(1 / spacing) + 1;
  std::vector<double> layer(static_cast<std::size_t>(n) + 1);  // of -dW/dz at whole spacings, over a lattice plane
  for (int k = 1; k <= n; k++)
    for (int a = -n; a <= n; a++)
      for (int b = -n; b <= n; b++) {
        const double q2 = spacing * spacing * (k * k + a * a + b * b);
        if (q2 < 1) layer[static_cast<std::size_t>(k)] -= spacing * spacing * spacing * Kernel::slope(q2) * k * spacing;
      }
  for (int depth = 0; depth < n; depth++) {
    double g = 0;
    for (int k = depth + 1; k <= n; k++) g += layer[static_cast<std::size_t>(k)];
    sum += spacing * areaOf(g);
  }
  return 1 / sum;
}

}  // namespace

double surfaceShare(double gradient) {
  const double x = std::clamp((gradient - 0.3) / 0.6, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

double surfaceAreaScale(const Numerics& n) {
  switch (n.kernel) {
    case KernelKind::Mcg03: return scaleOf<isa_base::Mcg03>(1 / n.support);
    case KernelKind::CubicSpline: return scaleOf<isa_base::CubicSpline>(1 / n.support);
    default: return scaleOf<isa_base::WendlandC2>(1 / n.support);
  }
}

double surfaceEnergy(double tension, double areaScale, double h, double gradient) { return tension * areaScale / h * areaOf(gradient); }

Vec3d kernelGradient(KernelKind kernel, const Vec3d& x) {
  const double q2 = dot(x, x);
  if (q2 >= 1 || q2 == 0) return {};
  switch (kernel) {
    case KernelKind::Mcg03: return x * isa_base::Mcg03::slope(q2);
    case KernelKind::CubicSpline: return x * isa_base::CubicSpline::slope(q2);
    default: return x * isa_base::WendlandC2::slope(q2);
  }
}

void findSurfaceStress(const WallContext& x, double areaScale, const WallContacts& contacts) {
  World& w = x.world;
  Continuum& p = w.particles;
  const double h = w.grid.support;
  for (const WallContact& c : contacts.list) {
    const WallIntegrals t = x.tables(c.distance / h);
    // the wall's own push, not that which a liquid feels (asLiquidsFeelIt)
    if (t.filling > 0) p.colourGradient[c.row] -= c.normal * (0.5 * t.push * t.space / t.filling * c.share);
  }
  for (std::size_t i = 0; i < p.owned; i++) {
    p.surfaceStress[i] = {};
    const Material& m = w.scene.materials[p.material[i]];
    const double f = p.liquid.active ? static_cast<double>(p.liquid[i]) : p.phase[i] == Liquid ? 1 : 0, g = length(p.colourGradient[i]);
    const double tension = surfaceEnergy(f * m.surfaceTension, areaScale, h, g);
    if (!(tension > 0)) continue;
    const Vec3d normal = p.colourGradient[i] / g;
    // (t M t + n n)^-1 - n n is the moment's inverse within the surface
    const Mat3d M = full(p.surfaceMoment[i]), nn = outer(normal, normal), t = identity3<double>() - nn, within = t * M * t + nn;
    Mat3d stress = (tension * holdingTogether) * nn;
    if (determinant(within) > 0.04)  // else too few neighbours along the surface: a lonely particle, or a pair
      stress = stress + (tension * (1 + madeUp * holdingTogether * dot(normal, M * normal))) * (inverse(within) - nn);
    p.surfaceStress[i] = symmetric(stress);
    p.interaction[i] += tension * p.mass[i] / m.density;
  }
}

}  // namespace thaw
