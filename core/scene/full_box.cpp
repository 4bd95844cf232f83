// SPDX-License-Identifier: Apache-2.0
#include "core/scene/full_box.hpp"

#include <cmath>

#include "core/scene/material_use.hpp"

namespace thaw {

bool liquidFillsTheBox(const Scene& s) {
  if (s.bodies.size() != 1 || !s.emitters.empty() || !s.obstacles.empty()) return false;
  const Body& b = s.bodies[0];
  const Material& m = s.materials[static_cast<std::size_t>(b.material)];
  if (m.canBeSolid() || b.shape.kind != ShapeKind::Box || b.shape.fitHeight || b.shape.bottom ||
      length(b.shape.rotate) > 0 || !b.clamp.empty())
    return false;
  const double little = 1e-6 * s.spacing;
  for (int a = 0; a < 3; a++) {
    const double half = 0.5 * b.shape.scale * b.shape.size[a],
                 middle = 0.5 * (s.domain.min[a] + s.domain.max[a]);
    if (s.domain.side[static_cast<std::size_t>(a)][0] != Side::Periodic ||
        std::abs(2 * half - (s.domain.max[a] - s.domain.min[a])) > little ||
        std::abs(b.shape.move[a] - middle) > little)
      return false;
  }
  return true;
}

bool someSurfaceTension(const Scene& s) {
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (s.materials[k].surfaceTension > 0 && inUse(s, k)) return true;
  return false;
}

}  // namespace thaw
