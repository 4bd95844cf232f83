// SPDX-License-Identifier: Apache-2.0
#include "core/surface/data/level_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace thaw {
namespace {

using std::numbers::pi;
constexpr int fine = 64, shells = 48, rings = 16;  // resolution of the quadratures

/// Kernel (1 - q^2)^3, normalised over the unit ball.
double kernel(double q2) {
  const double u = std::max(0.0, 1 - q2);
  return 315 / (64 * pi) * u * u * u;
}

/// Ball of radius 1 / curvature > 0, or the complement of a ball (< 0), in lengths of the kernel.
struct Round {
  bool cavity;
  // deepest: depth of the centre, or depth beyond which the colour is 1
  double radius, deepest;
  explicit Round(double curvature)
      : cavity(curvature < 0),
        radius(1 / std::max(std::abs(curvature), 1e-4)),
        deepest(cavity ? 1 : std::min(1.0, radius)) {}
  // Returns the distance from the centre.
  double place(double depth) const { return cavity ? radius + depth : radius - depth; }

  /// Sets the range of cosines, relative to the centre's direction, for which points at distance rho from a
  /// point at r are in the body.
  void directions(double r, double rho, double& low, double& high) const {
    double edge;
    if (r * rho < 1e-12) edge = r + rho < radius ? -1 : 1;
    else edge = std::clamp((rho * rho + (r - radius) * (r + radius)) / (2 * r * rho), -1.0, 1.0);
    low = cavity ? -1 : edge;
    high = cavity ? edge : 1;
  }
};

// Values at depths from 0 to Round::deepest.
using Profile = std::array<double, fine + 1>;

double valueAt(const Profile& p, double share) {
  const double s = std::clamp(share, 0.0, 1.0) * fine;
  const std::size_t at = std::min<std::size_t>(static_cast<std::size_t>(s), fine - 1);
  return p[at] + (s - static_cast<double>(at)) * (p[at + 1] - p[at]);
}

/// Integral over the body of the kernel around a point at `depth`, times the profile (null: 1), and its
/// inward moment.
struct Integral {
  double sum = 0, inward = 0;
};
Integral integrate(const Round& body, double depth, const Profile* profile) {
  const double r = body.place(depth);
  Integral out;
  for (int k = 0; k < shells; k++) {
    const double rho = (k + 0.5) / shells, shell = kernel(rho * rho) * 2 * pi * rho * rho / shells;
    double low, high;
    body.directions(r, rho, low, high);
    if (!profile) {
      out.sum += shell * (high - low);
      continue;
    }
    for (int m = 0; m < rings; m++) {
      const double mu = low + (high - low) * (m + 0.5) / rings,
                   away = std::sqrt(std::max(0.0, r * r + rho * rho - 2 * r * rho * mu));
      const double v = shell * (high - low) / rings *
                       valueAt(*profile, std::abs(body.radius - away) / body.deepest);
      out.sum += v;
      out.inward += v * rho * (body.cavity ? -mu : mu);
    }
  }
  return out;
}

struct Sample {
  double fullness, level, depth;
};
Sample sampleOf(double curvature) {
  const Round body(curvature);
  Profile colour, smoothed;
  for (int k = 0; k <= fine; k++)
    colour[static_cast<std::size_t>(k)] = integrate(body, body.deepest * k / fine, nullptr).sum;
  for (int k = 0; k <= fine; k++)
    smoothed[static_cast<std::size_t>(k)] = integrate(body, body.deepest * k / fine, &colour).sum;
  const Integral a = integrate(body, 0, &colour), b = integrate(body, 0, &smoothed);
  return {b.sum / a.sum, a.sum, a.inward / a.sum};
}

}  // namespace

void LevelTable::fill() {
  std::vector<Sample> samples{{0, 0, 0}};
  for (double curvature = 32; curvature > 0.02; curvature /= 1.15) samples.push_back(sampleOf(curvature));
  for (double curvature = 0; curvature > -1.21; curvature -= 0.1) samples.push_back(sampleOf(curvature));
  samples[0].depth = samples[1].depth;
  std::size_t k = 0;
  for (int e = 0; e <= entries; e++) {
    const double x = static_cast<double>(e) / entries;
    while (k + 2 < samples.size() && samples[k + 1].fullness < x) k++;
    const Sample &a = samples[k], &b = samples[k + 1];
    const double share = std::min(1.0, (x - a.fullness) / (b.fullness - a.fullness));
    level_[static_cast<std::size_t>(e)] = a.level + share * (b.level - a.level);
    depth_[static_cast<std::size_t>(e)] = a.depth + share * (b.depth - a.depth);
  }
}

double LevelTable::at(const std::array<double, entries + 1>& table, double x) {
  const double s = std::clamp(x, 0.0, 1.0) * entries;
  const std::size_t k = std::min<std::size_t>(static_cast<std::size_t>(s), entries - 1);
  return table[k] + (s - static_cast<double>(k)) * (table[k + 1] - table[k]);
}

}  // namespace thaw
