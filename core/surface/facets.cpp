#include "core/surface/facets.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

constexpr double sharp = 0.3;       // cosine of the angle of normals from which on two surfels are on the planes of an edge
constexpr double rounder = 0.35;

/// Eight times the height of the arc from one surfel to another over its chord, times the chord, m^2.
double bend(const Surfels& f, std::size_t a, std::size_t b) {
  const double flat = dot(f.normal[b] - f.normal[a], f.position[b] - f.position[a]), cosine = dot(f.normal[a], f.normal[b]);
  return cosine < sharp ? 2 * flat : (1 + rounder * (1 - cosine)) * flat;
}

}  // namespace

void measureFan(Surfels& f, std::size_t i, std::span<const std::uint32_t> ring) {
  const Vec3d x = f.position[i], n = f.normal[i];
  Vec3d facets{};
  double bulge = 0;
  for (std::size_t k = 0; k < ring.size(); k++) {
    const std::uint32_t ia = ring[k], ib = ring[k + 1 < ring.size() ? k + 1 : 0];
    const Vec3d a = f.position[ia] - x, b = f.position[ib] - x, twice = cross(a, b);
    const double a2 = dot(a, a), b2 = dot(b, b), ab = dot(a, b), twice2 = dot(twice, twice);
    if (dot(twice, n) < 0 || twice2 < 1e-12 * a2 * b2) continue;  // more than half a turn from one to the next: a rim; or all in a line
    const double share = std::clamp((a2 * (b2 - ab) + b2 * (a2 - ab)) / (4 * twice2), 0.0, 1.0);
    facets += (0.5 * share) * twice;
    bulge += share * std::sqrt(twice2) / 48 * (bend(f, i, ia) + bend(f, ia, ib) + bend(f, ib, i));
  }
  f.facets[i] = facets;
  f.bulge[i] = bulge;
}

}  // namespace thaw
