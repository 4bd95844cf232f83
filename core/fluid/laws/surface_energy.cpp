// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/laws/surface_energy.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/laws/surface_kernel.hpp"
#include "core/kernels/kernels.hpp"

namespace thaw {
namespace {

/// Calibration on drops at rest for supports of 1.5, 2, 2.5 and 3 spacings; linear in between.
struct Calibration {
  double rest;  ///< C, in units of sigma: energy of the flat lattice surface
  double open;  ///< fraction of C in the colour term
};
Calibration calibrationOf(double support) {
  constexpr double rest[] = {0.91, 0.81, 1.45, 1.36}, open[] = {0.6, 0.73, 0.6, 0.6};
  const double x = std::clamp(2 * support - 3, 0.0, 3.0);
  const int k = std::min(static_cast<int>(x), 2);
  return {rest[k] + (x - k) * (rest[k + 1] - rest[k]), open[k] + (x - k) * (open[k + 1] - open[k])};
}

/// Energy of missing colour, and its derivative. It is quadratic if little colour is missing, as at a flat
/// surface. A single layer lacks twice as much, and a single particle all of it. Their energies are about 2
/// and 4.8 sigma dx^2; a quadratic function would give 2.4 and 11.
struct ColourDeficit {
  double cost, slope;
};
ColourDeficit colourDeficitTerm(double open) {
  const double square = open * open, d = 1 / (1 + 2 * square);
  return {square * d, 2 * open * d * d};
}

/// Limit below which a neighbourhood is sparse, as a fraction of the colour sum at a flat lattice face. An
/// edge of a lattice is at the limit.
constexpr double sparseFraction = 0.8;

/// Factor of the squared gradient and term of sparse particles as functions of d, with derivatives.
struct AtRelativeDensity {
  double area = 0, areaSlope = 0, alone = 0, aloneSlope = 0;
};

AtRelativeDensity atRelativeDensity(const SurfaceMeasure& m, double fill) {
  const double least = std::max(fill, m.sparse), power = 1 / (least * least);
  if (fill >= m.sparse) return {power, -2 * power / fill, 0, 0};
  const double width = m.sparse - m.least, t = (fill - m.least) / width;  // 0 for a single particle, 1 where
                                                                          // the power begins
  const double a = 2 + 2 * width / m.sparse;                              // makes the slope continuous
  return {power * t * (a + (1 - a) * t), power * (a + 2 * (1 - a) * t) / width, (1 - t) * (1 - t),
          -2 * (1 - t) / width};
}

}  // namespace

SurfaceKernelValue surfaceKernelAt(const Vec3d& x) {
  const double q2 = dot(x, x);
  if (q2 >= 1) return {};
  return {x * isa_base::SurfaceKernel::slope(q2), isa_base::SurfaceKernel::w(q2)};
}

SurfaceMeasure surfaceMeasure(const Numerics& numerics, double spacing) {
  SurfaceMeasure m;
  m.spacing = spacing;
  m.support = numerics.support * spacing;
  const double e = 1 / numerics.support, V = e * e * e;
  const int n = static_cast<int>(numerics.support) + 1;
  // Sums over whole layers.
  std::vector<double> slope(static_cast<std::size_t>(n) + 1), colour(static_cast<std::size_t>(n) + 1);
  for (int k = 0; k <= n; k++)
    for (int a = -n; a <= n; a++)
      for (int b = -n; b <= n; b++) {
        if (k == 0 && a == 0 && b == 0) continue;
        const SurfaceKernelValue s = surfaceKernelAt(Vec3d{a * e, b * e, k * e});
        slope[static_cast<std::size_t>(k)] -= V * s.gradient.z;
        colour[static_cast<std::size_t>(k)] += V * s.colour;
      }
  m.full = colour[0];
  for (int k = 1; k <= n; k++) m.full += 2 * colour[static_cast<std::size_t>(k)];
  m.self = V * isa_base::SurfaceKernel::w(0.0);
  double sum = 0, opened = 0;
  for (int depth = 0; depth < n; depth++) {
    double g = 0, c = m.full;
    for (int k = depth + 1; k <= n; k++)
      g += slope[static_cast<std::size_t>(k)], c -= colour[static_cast<std::size_t>(k)];
    const double open = 1 - c / m.full;
    const double fill = (c + m.self) / (m.full + m.self);
    if (depth == 0) m.sparse = sparseFraction * fill;
    sum += e * g * g / (fill * fill);
    opened += colourDeficitTerm(open).cost;
  }
  const Calibration of = calibrationOf(numerics.support);
  m.area = of.rest * (1 - of.open) / sum;
  m.thin = of.rest * of.open / opened;
  m.least = m.self / (m.full + m.self);
  m.alone = std::cbrt(36 * isa_base::pi) - m.thin * colourDeficitTerm(1).cost;
  return m;
}

SurfaceState surfaceState(const SurfaceMeasure& m, double tension, const Vec3d& gradient, double colour) {
  const double fill = (colour + m.self) / (m.full + m.self), square = dot(gradient, gradient);
  const AtRelativeDensity by = atRelativeDensity(m, fill);
  const ColourDeficit open = colourDeficitTerm(std::max(0.0, 1 - colour / m.full));
  const double byArea = tension * m.area / m.support, byCover = tension * m.thin / m.spacing,
               byAlone = tension * m.alone / m.spacing;
  SurfaceState s;
  s.energy = byArea * by.area * square + byCover * open.cost + byAlone * by.alone;
  s.byGradient = gradient * (2 * byArea * by.area);
  s.byColour = (byArea * by.areaSlope * square + byAlone * by.aloneSlope) / (m.full + m.self) -
               byCover * open.slope / m.full;
  return s;
}

WallColour wallColour(double spacing, double distance) {
  WallColour sum;
  for (double z = distance + 0.5 * spacing; z < 1; z += spacing) {
    const double u = 1 - z * z, u2 = u * u;
    sum.colour += spacing * 315 / 256 * u2 * u2;
    sum.slope -= spacing * 315 / 32 * z * u * u2;
    sum.bend -= spacing * 315 / 32 * u2 * (u - 6 * z * z);
  }
  return sum;
}

}  // namespace thaw
