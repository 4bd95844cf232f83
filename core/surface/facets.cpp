#include "core/surface/facets.hpp"

namespace thaw {

void measureFan(Surfels& f, std::size_t i, std::span<const std::uint32_t> ring) {
  const Vec3d x = f.position[i], n = f.normal[i];
  const auto bend = [&](std::size_t a, std::size_t b) {
    const double between = dot(f.normal[b] - f.normal[a], f.position[b] - f.position[a]);
    return dot(f.normal[a], f.normal[b]) < cosFlat ? 2 * between : between;
  };
  Vec3d facets{};
  double bulge = 0;
  for (std::size_t k = 0; k < ring.size(); k++) {
    const std::uint32_t a = ring[k], b = ring[k + 1 < ring.size() ? k + 1 : 0];
    const Vec3d twice = cross(f.position[a] - x, f.position[b] - x);
    if (dot(twice, n) < 0) continue;  // more than half a turn from one to the next: a rim
    facets += twice / 6.0;
    bulge += length(twice) / 144 * (bend(i, a) + bend(a, b) + bend(b, i));
  }
  f.facets[i] = facets;
  f.bulge[i] = bulge;
}

}  // namespace thaw
