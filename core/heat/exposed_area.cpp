// SPDX-License-Identifier: Apache-2.0
#include "core/heat/exposed_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/heat/free_surface_sums.hpp"

namespace thaw {
namespace {

/// Missing weights, relative to a flat face, to the area of convex edges. Nearly multiplicative weights make
/// the logarithm additive: a corner has three faces.
double facesOf(const ExposedAreaLaw& law, double missing) {
  if (law.log < 1e-6) return missing;
  return std::log(std::max(1 - law.log * missing, 1e-3)) / std::log(1 - law.log);
}

/// Weights of a plane at a distance (reach), per particle and reach^2.
double planeWeight(double z) {
  const auto integral = [](double q) { return q * q * q / 3 - q * q * q * q * q / 5; };
  return z < 1 ? 2 * std::numbers::pi * (integral(1) - integral(z)) : 0;
}

/// Weights of the layers of a wall at a distance, both in spacings.
double wallWeight(double reach, double distance) {
  double sum = 0;
  for (double z = std::max(distance, 0.0) + 0.5; z < reach; z++) sum += planeWeight(z / reach);
  return sum;
}

}  // namespace

ExposedAreaLaw exposedAreaLaw(const Numerics& n) {
  ExposedAreaLaw law;
  const double reach = std::min(2.0, n.support);
  law.reach = reach / n.support;
  law.perVolume = n.support * n.support * n.support;
  double edge = 0;
  const auto last = static_cast<int>(reach);
  for (int x = -last; x <= last; x++)
    for (int y = -last; y <= last; y++)
      for (int z = -last; z <= last; z++) {
        const double r = std::sqrt(x * x + y * y + z * z), q = r / reach, w = q * std::max(0.0, 1 - q * q);
        if (w == 0) continue;
        law.full += w;
        if (z > 0) law.face += w, law.asymmetry += w * z / r;
        if (z > 0 || y > 0) edge += w;
      }
  law.log = 2 - edge / law.face;  // (1 - log)^2 = 1 - log edge / face
  law.thin = facesOf(law, 2) - 2;
  return law;
}

double areaOf(const ExposedAreaLaw& law, double sum, double asymmetry) {
  const double missing = (law.full - sum) / law.face;
  if (missing < 0.1) return std::max(missing, -1.0);
  return facesOf(law, missing) -
         law.thin * std::max(0.0, 1 - asymmetry / law.asymmetry) * std::max(0.0, missing - 1);
}

double coveredArea(const ExposedAreaLaw& law, double distance) {
  const double reach = std::cbrt(law.perVolume) * law.reach;
  return facesOf(law, wallWeight(reach, distance) / wallWeight(reach, 0.5));
}

double clearArea(double area) {
  constexpr double none = 0.18, all = 0.38;
  return area * std::clamp((area - none) / (all - none), 0.0, 1.0);
}

void findExposedAreas(const PairSums& sums, const Numerics& numerics, float* area, GroupRange range) {
  freeSurfaceKernels()->areas(sums, exposedAreaLaw(numerics), area, range);
}

}  // namespace thaw
