#include "core/surface/local_surface.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

void Patch::gather(const Surfels& s, std::size_t i, const RowLists& lists, double reach) {
  surfels = &s;
  centre = i;
  rows.clear();
  std::fill(curvature, curvature + 3, 0.0);
  for (std::uint64_t k = lists.first[i]; k < lists.end[i]; k++) {
    const std::uint32_t j = lists.row[k];
    const Vec3d d = s.position[j] - s.position[i];
    if (dot(d, d) < reach * reach && s.component[j] == s.component[i] && dot(s.normal[j], s.normal[i]) > oneSide) rows.push_back(j);
  }
}

void Patch::fitCurvature() {
  const Surfels& s = *surfels;
  const Vec3d u = s.tangent[centre], v = cross(s.normal[centre], u);
  Mat3d m{};
  Vec3d right{};
  for (const std::uint32_t j : rows) {
    const Vec3d d = s.position[j] - s.position[centre];
    const double a = dot(d, u), b = dot(d, v), p = dot(s.normal[j], u), q = dot(s.normal[j], v), weight = 1 / std::max(dot(d, d), 1e-300);
    m = m + weight * Mat3d{{{a * a, a * b, 0}, {a * b, a * a + b * b, a * b}, {0, a * b, b * b}}};
    right += weight * Vec3d{p * a, p * b + q * a, q * b};
  }
  // each weighted term is at most 1: a determinant far below that of neighbours all around means a direction is missing
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
  const double sink = 0.5 * k * distance * distance, flat = std::sqrt(std::max(distance * distance - sink * sink, 0.0));
  const Vec3d turned = (c * p.curvature[0] + s * p.curvature[1]) * u + (c * p.curvature[1] + s * p.curvature[2]) * v;
  return {f.position[p.centre] + flat * along - sink * n, normalized(n * (1 - k * sink) + flat * turned)};
}

SurfacePoint ontoSurface(const Patch& p, SurfacePoint x, double reach) {
  const Surfels& s = *p.surfels;
  const double reach2 = reach * reach, back2 = 1 / reach2;
  for (int round = 0; round < 4; round++) {
    double sum = 0, along = 0;  // of weights w, and of w n_j . d
    Vec3d normal{}, away{};     // of w n_j, and of w d
    const auto add = [&](std::size_t j) {
      const Vec3d d = x.position - s.position[j], n = s.normal[j];
      const double r2 = dot(d, d);
      if (r2 >= reach2) return;
      const double u = 1 - r2 * back2, w = u * u * u;
      sum += w;
      normal += w * n;
      away += w * d;
      along += w * dot(n, d);
    };
    add(p.centre);
    for (const std::uint32_t j : p.rows) add(j);
    if (!(sum > 0) || !(dot(normal, normal) > 0.01 * sum * sum)) return x;
    x.normal = normalized(normal);
    const double height = 0.5 * (dot(x.normal, away) + along) / sum;
    x.position -= x.normal * height;
    if (std::abs(height) < 1e-5 * reach) break;
  }
  return x;
}

}  // namespace thaw
