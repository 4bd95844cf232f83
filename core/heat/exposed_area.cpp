// SPDX-License-Identifier: Apache-2.0
#include "core/heat/exposed_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/heat/free_surface_sums.hpp"

namespace thaw {
namespace {

// The area is the sum of a function of the missing weights and a function of the asymmetry. Both arguments
// are relative to a flat face of the lattice. These piecewise linear functions are fitted to the total
// areas of 750 bodies (docs/theory/heat.md). A flat face, an edge and a plate of one layer are exact.
constexpr double missingStep = 0.25, asymmetryStep = 0.125;
constexpr std::array<double, 14> areaOfMissing{0,     0, 0.357, 0.357, 0.357, 0.572, 0.572,
                                               1.485, 2, 2.553, 3.124, 3.686, 5.158, 7.304};
constexpr std::array<double, 11> areaOfAsymmetry{0,     0,    0,     0.153, 0.153, 0.153,
                                                 0.153, 0.61, 0.643, 0.779, 0.779};

/// Linear interpolation between values at 0, 1, 2, ..., constant outside.
template<std::size_t N> double interpolate(const std::array<double, N>& values, double x) {
  if (!(x > 0)) return values[0];
  if (x >= N - 1) return values[N - 1];
  const auto k = static_cast<std::size_t>(x);
  return values[k] + (x - static_cast<double>(k)) * (values[k + 1] - values[k]);
}

/// Converts missing weights, relative to a flat face, to an area in faces. Weights at convex edges are nearly
/// multiplicative, so their logarithms add up: a corner has three faces.
double facesOf(const ExposedAreaLaw& law, double missing) {
  if (law.log < 1e-6) return missing;
  return std::log(std::max(1 - law.log * missing, 1e-3)) / std::log(1 - law.log);
}

double areaFrom(const ExposedAreaLaw& law, double missing, double asymmetry) {
  if (law.fitted)
    return interpolate(areaOfMissing, missing / missingStep) +
           interpolate(areaOfAsymmetry, asymmetry / asymmetryStep);
  if (missing < 0.1) return 0;
  return clearArea(facesOf(law, missing) -
                   law.thin * std::max(0.0, 1 - asymmetry) * std::max(0.0, missing - 1));
}

struct FaceWeights {
  double sum = 0, asymmetry = 0;
};

/// Adds the weights of a plane at a distance (reach), per particle and reach^2.
void addPlane(double z, FaceWeights& w) {
  if (z >= 1) return;
  const auto integral = [](double q) { return q * q * q / 3 - q * q * q * q * q / 5; };
  const auto along = [](double q) { return q * q / 2 - q * q * q * q / 4; };
  w.sum += 2 * std::numbers::pi * (integral(1) - integral(z));
  w.asymmetry += 2 * std::numbers::pi * z * (along(1) - along(z));
}

/// Weights of the layers of a wall at a distance, both in spacings.
FaceWeights wallWeights(double reach, double distance) {
  FaceWeights w;
  for (double z = std::max(distance, 0.0) + 0.5; z < reach; z++) addPlane(z / reach, w);
  return w;
}

}  // namespace

ExposedAreaLaw exposedAreaLaw(const Numerics& n) {
  ExposedAreaLaw law;
  const double reach = std::min(2.0, n.support);
  law.reach = reach / n.support;
  law.perVolume = n.support * n.support * n.support;
  law.fitted = reach == 2;
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
  return areaFrom(law, (law.full - sum) / law.face, asymmetry / law.asymmetry);
}

double coveredArea(const ExposedAreaLaw& law, double distance) {
  const double reach = std::cbrt(law.perVolume) * law.reach;
  const FaceWeights wall = wallWeights(reach, distance), face = wallWeights(reach, 0.5);
  return areaFrom(law, wall.sum / face.sum, wall.asymmetry / face.asymmetry);
}

double clearArea(double area) {
  constexpr double none = 0.18, all = 0.38;
  return area * std::clamp((area - none) / (all - none), 0.0, 1.0);
}

void findExposedAreas(const PairSums& sums, const Numerics& numerics, float* area, GroupRange range) {
  freeSurfaceKernels()->areas(sums, exposedAreaLaw(numerics), area, range);
}

}  // namespace thaw
