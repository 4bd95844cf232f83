// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/local_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {

void Patch::gather(const Surfels& s, std::size_t i, const RowLists& lists, double reach) {
  surfels = &s;
  centre = i;
  rows.clear();
  std::fill(curvature, curvature + 3, 0.0);
  for (std::uint64_t k = lists.first[i]; k < lists.end[i]; k++) {
    const std::uint32_t j = lists.row[k];
    const Vec3d d = s.position[j] - s.position[i];
    if (dot(d, d) < reach * reach && s.component[j] == s.component[i] &&
        dot(s.normal[j], s.normal[i]) > oneSide)
      rows.push_back(j);
  }
}

void Patch::fitCurvature() {
  const Surfels& s = *surfels;
  const Vec3d u = s.tangent[centre], v = cross(s.normal[centre], u);
  double aa = 0, ab = 0, bb = 0;
  Vec3d right{};
  for (const std::uint32_t j : rows) {
    const Vec3d d = s.position[j] - s.position[centre];
    const double a = dot(d, u), b = dot(d, v), p = dot(s.normal[j], u), q = dot(s.normal[j], v),
                 weight = 1 / std::max(dot(d, d), 1e-300);
    aa += weight * (a * a), ab += weight * (a * b), bb += weight * (b * b);
    right += weight * Vec3d{p * a, p * b + q * a, q * b};
  }
  const Mat3d m{{{aa, ab, 0}, {ab, aa + bb, ab}, {0, ab, bb}}};
  // Each weighted term is at most 1. A determinant far below the value for evenly distributed neighbours
  // indicates a direction without neighbours.
  const double n = static_cast<double>(rows.size()), det = determinant(m);
  if (!(det > 1e-3 * n * n * n / 27)) return;
  const Vec3d c = inverse(m) * right;
  for (int k = 0; k < 3; k++) curvature[k] = c[k];
}

double Patch::largestCurvature() const {
  const double mean = 0.5 * (curvature[0] + curvature[2]), half = 0.5 * (curvature[0] - curvature[2]);
  return std::abs(mean) + std::sqrt(half * half + curvature[1] * curvature[1]);
}

SurfacePoint pointAround(const Patch& p, double distance, double c, double s) {
  const Surfels& f = *p.surfels;
  const Vec3d n = f.normal[p.centre], u = f.tangent[p.centre], v = cross(n, u), along = c * u + s * v;
  double k = c * c * p.curvature[0] + 2 * c * s * p.curvature[1] + s * s * p.curvature[2];
  k = std::clamp(k, -1.2 / distance, 1.2 / distance);
  const double sink = 0.5 * k * distance * distance,
               flat = std::sqrt(std::max(distance * distance - sink * sink, 0.0));
  const Vec3d turned = (c * p.curvature[0] + s * p.curvature[1]) * u +
                       (c * p.curvature[1] + s * p.curvature[2]) * v;
  return {f.position[p.centre] + flat * along - sink * n, normalized(n * (1 - k * sink) + flat * turned)};
}

void projectToPatch(Patch& p, SurfacePoint* points, std::size_t n, double reach) {
  const Surfels& s = *p.surfels;
  const std::size_t discs = 1 + p.rows.size();
  p.disc.resize(6 * discs);
  for (std::size_t k = 0; k < discs; k++) {
    const std::size_t j = k == 0 ? p.centre : p.rows[k - 1];
    for (std::size_t a = 0; a < 3; a++)
      p.disc[6 * k + a] = s.position[j][static_cast<int>(a)],
                     p.disc[6 * k + 3 + a] = s.normal[j][static_cast<int>(a)];
  }
  alignas(32) std::array<double, 24> place{};
  alignas(32) std::array<double, 8 * patchSums> sums;
  std::array<std::size_t, 8> of;  // index of the point in each lane
  for (std::size_t k = 0; k < n; k++) of[k] = k;
  const double reach2 = reach * reach;
  for (int round = 0; round < 4 && n > 0; round++) {
    for (std::size_t k = 0; k < n; k++)
      for (std::size_t a = 0; a < 3; a++) place[8 * a + k] = points[of[k]].position[static_cast<int>(a)];
    bestSurfaceKernels().betweenDiscs({p.disc.data(), discs, place.data(), reach2, 1 / reach2}, sums.data());
    std::size_t left = 0;
    for (std::size_t k = 0; k < n; k++) {
      const auto three = [&](std::size_t sum) {
        return Vec3d{sums[8 * sum + k], sums[8 * (sum + 1) + k], sums[8 * (sum + 2) + k]};
      };
      const double weight = sums[8 * PatchWeight + k];
      const Vec3d normal = three(PatchNormal);
      if (!(weight > 0) || !(dot(normal, normal) > 0.01 * weight * weight)) continue;
      SurfacePoint& x = points[of[k]];
      x.normal = normalized(normal);
      const double height = 0.5 * (dot(x.normal, three(PatchAway)) + sums[8 * PatchAlong + k]) / weight;
      x.position -= x.normal * height;
      if (std::abs(height) >= 1e-5 * reach) of[left++] = of[k];
    }
    n = left;
  }
}

}  // namespace thaw
