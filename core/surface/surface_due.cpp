// SPDX-License-Identifier: Apache-2.0
#include "core/surface/surface_due.hpp"

#include "core/surface/measures/small_drops.hpp"
#include "core/surface/seeding/grow.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

double largestSurfaceMove2(const CellGrid& grid, const Continuum& p, const Surface& surface) {
  double most = 0;
  SmallDrops small(surface);
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.component[i] == noComponent || small(p.component[i])) continue;
    Vec3d u = p.position[i] - p.surfacePosition[i];
    for (int a = 0; a < 3; a++)
      if (grid.periodic[a]) u[a] -= grid.period[a] * std::nearbyint(u[a] / grid.period[a]);
    most = std::max(most, dot(u, u));
  }
  return most;
}

bool surfaceDue(const Scene& scene, const Clock& clock, const CellGrid& grid, const Surface& surface,
                double move2) {
  const SurfaceSettings& s = scene.surface;
  if (s.everySteps > 0 && clock.step - surface.lastStep >= s.everySteps) return true;
  const double far = s.everyMove * grid.support;
  return far > 0 && move2 >= far * far;
}

}  // namespace thaw
