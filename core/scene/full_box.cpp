#include "core/scene/full_box.hpp"

#include <cmath>

namespace thaw {

bool liquidFillsTheBox(const Scene& s) {
  if (s.bodies.size() != 1 || !s.emitters.empty() || !s.obstacles.empty()) return false;
  const Body& b = s.bodies[0];
  const Material& m = s.materials[static_cast<std::size_t>(b.material)];
  if (m.canBeSolid() || b.shape.kind != ShapeKind::Box || b.shape.fitHeight || b.shape.bottom || length(b.shape.rotate) > 0 || !b.clamp.empty()) return false;
  const double little = 1e-6 * s.spacing;
  for (int a = 0; a < 3; a++) {
    const double half = 0.5 * b.shape.scale * b.shape.size[a], middle = 0.5 * (s.domain.min[a] + s.domain.max[a]);
    if (s.domain.side[static_cast<std::size_t>(a)][0] != Side::Periodic || std::abs(2 * half - (s.domain.max[a] - s.domain.min[a])) > little || std::abs(b.shape.move[a] - middle) > little) return false;
  }
  return true;
}

bool liquidIsFree(const Scene& s) {
  if (s.bodies.empty() || !s.emitters.empty() || !s.obstacles.empty() || !s.oriented.empty() || !s.sheets.empty()) return false;
  if (length(s.domain.gravity) > 0) return false;
  for (const auto& sides : s.domain.side)
    if (sides[0] == Side::Wall || sides[1] == Side::Wall) return false;
  for (const Body& b : s.bodies) {
    const Material& m = s.materials[static_cast<std::size_t>(b.material)];
    if (m.canBeSolid() || m.surfaceTension > 0 || !b.clamp.empty()) return false;
  }
  return true;
}

}  // namespace thaw
