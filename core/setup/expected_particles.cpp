#include "core/setup/expected_particles.hpp"

namespace thaw {
namespace {

constexpr double notMuch = 1e6;  // particles, for which no machine is too small
constexpr int coarse = 24;       // points along each edge of the bounding box

double insideShare(const SignedDistance& shape, const Bounds& b) {
  int inside = 0;
  for (int k = 0; k < coarse * coarse * coarse; k++) {
    const Vec3d at{(k % coarse + 0.5) / coarse, (k / coarse % coarse + 0.5) / coarse, (k / coarse / coarse + 0.5) / coarse};
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
  const auto at = [](int x, int y, int z) { return static_cast<std::size_t>((z * n + y) * n + x); };
  double sum = 0;
  for (const auto& shape : shapes) {
    const Bounds b = shape->bounds();
    const Vec3d size = b.max - b.min, cell = size * (1.0 / (n - 2));  // a margin of one cell, which is outside
    for (int z = 0; z < n; z++)
      for (int y = 0; y < n; y++)
        for (int x = 0; x < n; x++) in[at(x, y, z)] = shape->inside({b.min.x + (x - 0.5) * cell.x, b.min.y + (y - 0.5) * cell.y, b.min.z + (z - 0.5) * cell.z});
    double crossed = 0;
    for (int a = 0; a < n; a++)
      for (int c = 0; c < n; c++)
        for (int k = 0; k + 1 < n; k++) {
          crossed += (in[at(k, a, c)] != in[at(k + 1, a, c)]) * cell.y * cell.z;
          crossed += (in[at(a, k, c)] != in[at(a, k + 1, c)]) * cell.x * cell.z;
          crossed += (in[at(a, c, k)] != in[at(a, c, k + 1)]) * cell.x * cell.y;
        }
    sum += 2.0 / 3 * crossed;  // a line along an axis meets a surface of area A |n_a| A times; the mean of |n_a| over directions is 1/2
  }
  return sum;
}

}  // namespace thaw
