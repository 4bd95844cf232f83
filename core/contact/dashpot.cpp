// SPDX-License-Identifier: Apache-2.0
#include "core/contact/dashpot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace thaw {
namespace {

/// Coefficient of restitution for a damping ratio z: exp(-z t), where t is the end of contact in units of
/// 1/omega_0.
double restitutionOf(double z) {
  const double d = 1 - z * z;
  if (std::abs(d) < 1e-9) return std::exp(-2.0);
  const double w = std::sqrt(std::abs(d));
  const double t = d > 0 ? std::atan2(2 * z * w, 2 * z * z - 1) / w
                         : std::atanh(2 * z * w / (2 * z * z - 1)) / w;
  return std::exp(-z * t);
}

constexpr std::size_t points = 512;
constexpr double least = 0.025, strongest = 3.1;

std::array<double, points + 1> table() {
  std::array<double, points + 1> ratio{};
  for (std::size_t k = 0; k <= points; k++) {
    const double e = least + (1 - least) * static_cast<double>(k) / points;
    double low = 0, high = strongest;  // restitution decreases with the ratio
    for (int n = 0; n < 60; n++) {
      const double middle = 0.5 * (low + high);
      (restitutionOf(middle) > e ? low : high) = middle;
    }
    ratio[k] = 0.5 * (low + high);
  }
  ratio[points] = 0;
  return ratio;
}

}  // namespace

double dashpotRatio(double restitution) {
  static const std::array<double, points + 1> ratio = table();
  const double x = std::clamp((restitution - least) / (1 - least), 0.0, 1.0) * points;
  const std::size_t k = std::min(static_cast<std::size_t>(x), points - 1);
  const double t = x - static_cast<double>(k);
  return ratio[k] + t * (ratio[k + 1] - ratio[k]);
}

}  // namespace thaw
