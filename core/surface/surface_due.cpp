#include "core/surface/surface_due.hpp"

#include "core/surface/grow.hpp"
#include "core/surface/measure.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

double largestSurfaceMove2(const World& w) {
  const Continuum& p = w.particles;
  double most = 0;
  std::uint64_t last = noComponent;  // looked up
  bool drop = false;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.component[i] == noComponent) continue;
    if (p.component[i] != last) {
      last = p.component[i];
      const SurfaceComponent* c = findComponent(w.surface, last);
      drop = c && c->particles <= smallDrop;
    }
    if (drop) continue;
    Vec3d u = p.position[i] - p.surfacePlace[i];
    for (int a = 0; a < 3; a++)
      if (w.grid.periodic[a]) u[a] -= w.grid.period[a] * std::nearbyint(u[a] / w.grid.period[a]);
    most = std::max(most, dot(u, u));
  }
  return most;
}

bool surfaceDue(const World& w, double move2) {
  const SurfaceSettings& s = w.scene.surface;
  if (s.everySteps > 0 && w.clock.step - w.surface.lastStep >= s.everySteps) return true;
  const double far = s.everyMove * w.grid.support;
  return far > 0 && move2 >= far * far;
}

}  // namespace thaw
