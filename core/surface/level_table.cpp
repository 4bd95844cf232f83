#include "core/surface/level_table.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace thaw {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Cosine, seen from a point at r from the middle of a ball of radius R, of the cap of directions in which points at distance rho are in
/// the ball: those toward the middle, with a cosine above it.
double capCosine(double r, double R, double rho) {
  if (r * rho < 1e-12) return r + rho < R ? -1 : 1;
  return std::clamp((rho * rho + (r - R) * (r + R)) / (2 * r * rho), -1.0, 1.0);
}

/// Share of the kernel at r that lies in the ball.
double colourIn(double r, double R) {
  constexpr int n = 200;
  double sum = 0;
  for (int k = 0; k < n; k++) {
    const double rho = (k + 0.5) / n;
    sum += colourKernel(rho * rho) * 4 * pi * rho * rho * 0.5 * (1 - capCosine(r, R, rho)) / n;
  }
  return sum;
}

struct Sample { double mean, level, depth; };

/// On the surface of a ball of curvature 1/R > 0, or in a cavity (< 0).
Sample sampleAt(double curvature) {
  const bool cavity = curvature < 0;
  const double R = 1 / std::max(std::abs(curvature), 1e-4);
  // colour by distance from the surface, into the body
  constexpr int fine = 128, shells = 100, rings = 48;
  const double deepest = cavity ? 1 : std::min(1.0, R);
  std::array<double, fine + 1> colour;
  for (int k = 0; k <= fine; k++) {
    const double s = deepest * k / fine;
    colour[static_cast<std::size_t>(k)] = cavity ? 1 - colourIn(R + s, R) : colourIn(R - s, R);
  }
  Sample out{0, 0, 0};
  for (int k = 0; k < shells; k++) {
    const double rho = (k + 0.5) / shells, shell = colourKernel(rho * rho) * 2 * pi * rho * rho / shells, edge = capCosine(R, R, rho);
    const double low = cavity ? -1 : edge, high = cavity ? edge : 1;
    out.level += shell * (high - low);
    out.depth += shell * rho * 0.5 * std::abs(high * high - low * low);
    for (int m = 0; m < rings; m++) {
      const double mu = low + (high - low) * (m + 0.5) / rings, away = std::sqrt(std::max(0.0, R * R + rho * rho - 2 * R * rho * mu));
      const double s = std::clamp((cavity ? away - R : R - away) / deepest, 0.0, 1.0) * fine;
      const std::size_t at = std::min<std::size_t>(static_cast<std::size_t>(s), fine - 1);
      out.mean += shell * (high - low) / rings * (colour[at] + (s - static_cast<double>(at)) * (colour[at + 1] - colour[at]));
    }
  }
  out.mean /= out.level;
  out.depth /= out.level;
  return out;
}

}  // namespace

double colourKernel(double q2) {
  const double u = std::max(0.0, 1 - q2);
  return 315 / (64 * pi) * u * u * u;
}

LevelTable::LevelTable() {
  std::vector<Sample> samples{{0, 0, 0}};
  for (double curvature = 32; curvature > 0.02; curvature /= 1.15) samples.push_back(sampleAt(curvature));
  for (double curvature = 0; curvature > -1.21; curvature -= 0.1) samples.push_back(sampleAt(curvature));
  samples[0].depth = samples[1].depth;
  std::size_t k = 0;
  for (int e = 0; e <= entries; e++) {
    const double x = static_cast<double>(e) / entries;
    while (k + 2 < samples.size() && samples[k + 1].mean < x) k++;
    const Sample &a = samples[k], &b = samples[k + 1];
    const double share = std::min(1.0, (x - a.mean) / (b.mean - a.mean));
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
