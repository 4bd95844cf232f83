// SPDX-License-Identifier: Apache-2.0
#include "core/terms/outside_forces.hpp"

#include <algorithm>

#include "core/particles/sleep_stage.hpp"

namespace thaw {

bool isFree(const Continuum& p, std::size_t i) {
  return !(p.clamped.active && p.clamped[i]) && !(p.sleep.active && p.sleep[i] != awake);
}

void addOutsideLoads(const std::vector<OutsideSource>& sources, OutsideLoad load) {
  Continuum& p = load.particles;
  const std::size_t n = p.owned;
  std::fill_n(p.outsideForce.data(), n, Vec3d{});
  std::vector<double> heat(p.heatFlow.active ? n : 0, 0.0);
  load.force = p.outsideForce.data();
  load.heat = heat.empty() ? nullptr : heat.data();
  for (const OutsideSource& source : sources) source(load);
  for (std::size_t i = 0; i < n; i++) {
    if (isFree(p, i)) p.force[i] += p.outsideForce[i];
    else p.outsideForce[i] = {};
  }
  for (std::size_t i = 0; i < heat.size(); i++) {
    if (heat[i] == 0) continue;
    p.heatFlow[i] += heat[i];
    load.run.ledger.heatIn.add(heat[i] * load.dt);
  }
}

void KickOfForce::record(const Continuum& p, std::size_t i, const Vec3d& f, Ledger& ledger) const {
  const double half = 0.5 * dt;
  const Vec3d a = kick == HalfKick::First ? p.acceleration[i] : p.force[i] * (1 / p.mass[i]) + gravity;
  ledger.wallWork.add(dot(f, p.velocity[i] + a * (0.5 * half)) * half);
  for (int axis = 0; axis < 3; axis++) ledger.wallImpulse[axis].add(f[axis] * half);
}

void recordOutsideKick(const Continuum& p, HalfKick kick, const Vec3d& gravity, double dt, Ledger& ledger) {
  const KickOfForce force{kick, gravity, dt};
  for (std::size_t i = 0; i < p.owned; i++)
    if (!(p.outsideForce[i] == Vec3d{})) force.record(p, i, p.outsideForce[i], ledger);
}

}  // namespace thaw
