// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/facets.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

// Cosine of the angle between normals below which two surfels lie on different planes of an edge.
constexpr double sharp = 0.3;
constexpr double rounder = 0.35;

/// Returns eight times the height of the arc above a chord, times the chord's length (m^2). n and m: normals
/// at its ends.
double archOver(const Vec3d& chord, const Vec3d& n, const Vec3d& m) {
  const double flat = dot(m - n, chord), cosine = dot(n, m);
  return (cosine < sharp ? 2 : 1 + rounder * (1 - cosine)) * flat;
}

/// Neighbour relative to the surfel.
struct Spoke {
  Vec3d to, normal;
  double length2, bend;
  Spoke(const Surfels& f, std::size_t i, std::size_t j)
      : to(f.position[j] - f.position[i]),
        normal(f.normal[j]),
        length2(dot(to, to)),
        bend(archOver(to, f.normal[i], normal)) {}
};

}  // namespace

void measureFan(Surfels& f, std::size_t i, std::span<const std::uint32_t> ring) {
  f.facets[i] = {};
  f.bulge[i] = 0;
  if (ring.size() < 2) return;
  const Vec3d n = f.normal[i];
  Vec3d facets{};
  double bulge = 0;
  const Spoke first(f, i, ring[0]);
  Spoke a = first;
  for (std::size_t k = 1; k <= ring.size(); k++) {
    const Spoke b = k < ring.size() ? Spoke(f, i, ring[k]) : first;
    const Vec3d twice = cross(a.to, b.to);
    const double between = dot(a.to, b.to), twice2 = dot(twice, twice);
    // Otherwise, the angle to the next neighbour exceeds half a revolution (a rim), or all three points are
    // collinear.
    if (dot(twice, n) > 0 && twice2 > 1e-12 * a.length2 * b.length2) {
      const double share = std::clamp(
          (a.length2 * (b.length2 - between) + b.length2 * (a.length2 - between)) / (4 * twice2), 0.0, 1.0);
      facets += (0.5 * share) * twice;
      bulge += share * std::sqrt(twice2) / 48 * (a.bend + b.bend + archOver(b.to - a.to, a.normal, b.normal));
    }
    a = b;
  }
  f.facets[i] = facets;
  f.bulge[i] = bulge;
}

}  // namespace thaw
