#include "core/time/integrate.hpp"

#include <cmath>

namespace thaw {

void kickAndDrift(World& w, double dt) {
  Continuum& p = w.particles;
  const double half = 0.5 * dt;
  const bool smoothed = p.smoothing.active;
  for (std::size_t i = 0; i < p.owned; i++) {
    p.velocity[i] += p.acceleration[i] * half;
    p.position[i] += (smoothed ? p.velocity[i] + p.smoothing[i] : p.velocity[i]) * dt;
  }
}

bool finishKick(World& w, double dt, std::size_t* bad) {
  Continuum& p = w.particles;
  const Vec3d g = w.scene.domain.gravity;
  const double half = 0.5 * dt;
  const bool clamps = p.clamped.active;
  bool finite = true;
  for (std::size_t i = p.owned; i-- > 0;) {
    Vec3d a = p.force[i] / p.mass[i] + g;
    if (clamps && p.clamped[i]) {
      for (int k = 0; k < 3; k++) w.ledger.wallImpulse[k].add(-(p.force[i][k] + g[k] * p.mass[i]) * dt);  // what holds it pushes back
      a = {};
    }
    if (!std::isfinite(a.x + a.y + a.z + p.position[i].x + p.position[i].y + p.position[i].z + p.velocity[i].x + p.velocity[i].y + p.velocity[i].z)) {
      finite = false;
      *bad = i;
    }
    p.acceleration[i] = a;
    p.velocity[i] += a * half;
    p.dissipated[i] += p.dissipation[i] * dt;
  }
  return finite;
}

}  // namespace thaw
