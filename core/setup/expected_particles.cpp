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

}  // namespace thaw
