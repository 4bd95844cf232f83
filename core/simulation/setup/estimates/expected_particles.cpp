// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/estimates/expected_particles.hpp"

#include <cmath>

namespace thaw {
namespace {

constexpr double notMuch = 1e6;  // number of particles below which no better estimate is needed
constexpr int coarse = 24;       // points along each edge of the bounding box

double insideShare(const SignedDistance& shape, const Bounds& b) {
  int inside = 0;
  for (int k = 0; k < coarse * coarse * coarse; k++) {
    const Vec3d at{(k % coarse + 0.5) / coarse, (k / coarse % coarse + 0.5) / coarse,
                   (k / coarse / coarse + 0.5) / coarse};
    const Vec3d size = b.max - b.min;
    inside += shape.inside({b.min.x + at.x * size.x, b.min.y + at.y * size.y, b.min.z + at.z * size.z});
  }
  return static_cast<double>(inside) / (coarse * coarse * coarse);
}

}  // namespace

double expectedParticles(const std::vector<std::shared_ptr<const SignedDistance>>& shapes, double spacing) {
  double sum = 0;
  for (const auto& shape : shapes) {
    const Bounds b = shape->bounds();
    const Vec3d size = (b.max - b.min) * (1 / spacing);
    const double most = size.x * size.y * size.z;
    sum += most > notMuch ? most * insideShare(*shape, b) : most;
  }
  return sum;
}

double expectedArea(const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  constexpr int n = 32;
  std::vector<char> in(n * n * n);
  const auto at = [](const int(&c)[3]) {
    return (static_cast<std::size_t>(c[2]) * n + static_cast<std::size_t>(c[1])) * n +
           static_cast<std::size_t>(c[0]);
  };
  double sum = 0;
  for (const auto& shape : shapes) {
    if (const double known = shape->area(); known >= 0) {
      sum += known;
      continue;
    }
    const Bounds b = shape->bounds();
    // One outside cell as a margin.
    const Vec3d size = b.max - b.min, cell = size * (1.0 / (n - 2));
    const auto place = [&](double x, double y, double z) {
      return b.min + Vec3d{(x - 0.5) * cell.x, (y - 0.5) * cell.y, (z - 0.5) * cell.z};
    };
    for (int z = 0; z < n; z++)
      for (int y = 0; y < n; y++)
        for (int x = 0; x < n; x++) in[at({x, y, z})] = shape->inside(place(x, y, z));
    // A piece of area A and normal n is crossed by |n_a| A / (area of a cell across a) lines along axis a.
    // The sum over all crossings of that area / (|n_x| + |n_y| + |n_z|) is A.
    for (int z = 0; z < n; z++)
      for (int y = 0; y < n; y++)
        for (int x = 0; x < n; x++)
          for (int a = 0; a < 3; a++) {
            int next[3] = {x, y, z};
            if (++next[a] == n || in[at({x, y, z})] == in[at(next)]) continue;
            Vec3d g;
            shape->distanceWithin(place(0.5 * (x + next[0]), 0.5 * (y + next[1]), 0.5 * (z + next[2])),
                                  length(cell), &g);
            const double lines = std::abs(g.x) + std::abs(g.y) + std::abs(g.z),
                         across = cell[(a + 1) % 3] * cell[(a + 2) % 3];
            sum += across / (lines > 0 ? lines : 1.5);  // 3/2: mean over all directions
          }
  }
  return sum;
}

}  // namespace thaw
