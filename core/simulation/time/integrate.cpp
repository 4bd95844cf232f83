// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/time/integrate.hpp"

#include <algorithm>
#include <cmath>

#include "core/domain/sides.hpp"
#include "core/particles/shifted.hpp"
#include "core/particles/sleep_stage.hpp"

namespace thaw {

namespace {

/// Records the impulses applied to particles in half a kick by walls, and by the weight of the mass that
/// entered and left.
void recordImpulses(Ledger& l, const Scene& scene, double half) {
  for (int a = 0; a < 3; a++) {
    const double g = scene.domain.gravity[a] * half;
    l.wallImpulse[a].addProduct(l.wallForce[a], half);
    if (g == 0) continue;
    l.gravityImpulse[a].addProduct(l.entered.mass, g);
    l.gravityImpulse[a].addProduct(l.left.mass, -g);
  }
}

}  // namespace

Vec3d forceOf(const Continuum& p, const Scene& scene, std::size_t i) {
  return p.force.shares() ? (p.acceleration[i] - scene.domain.gravity) * p.mass[i] : p.force[i];
}

bool kickAndDrift(World& w, double dt, std::span<const RowSpan> rows) {
  Continuum& p = w.particles;
  const double half = 0.5 * dt;
  recordImpulses(w.ledger, w.scene, half);
  const double lessFast = 1.0 / w.clock.substeps - 1;  // fast forces act for half a substep
  const bool shifted = p.shiftingVelocity.active, carried = w.modules.continuity,
             substeps = w.clock.substeps > 1;
  const Vec3d g = w.scene.domain.gravity;
  const OpenBox box = openBox(w.scene.domain);
  bool leaves = false;
  for (const RowSpan& range : rows)
    for (std::size_t i = range.begin; i < range.end; i++) {
      if (shifted) {
        // Records the work of shifting against forces that depend on positions. With a carried density, the
        // pressure is not such a force.
        p.dissipated[i] += p.mass[i] * dt * dot(carried ? g : p.acceleration[i], p.shiftingVelocity[i]);
        if (p.positionForce.active) p.dissipated[i] += dt * dot(p.positionForce[i], p.shiftingVelocity[i]);
      }
      p.velocity[i] += p.acceleration[i] * half;
      if (substeps) {
        if (!(p.clamped.active && p.clamped[i])) p.velocity[i] += p.fastAcceleration[i] * (lessFast * half);
        if (takesSubsteps(p, i)) continue;
      }
      const Vec3d x = p.position[i] +
                      (isShifted(p, i) ? p.velocity[i] + p.shiftingVelocity[i] : p.velocity[i]) * dt;
      p.position[i] = x;
      leaves |= box.leaves(x);
    }
  return leaves;
}

bool finishKick(World& w, double dt, std::span<const RowSpan> rows, std::size_t* bad, LargestRates* largest) {
  Continuum& p = w.particles;
  const Vec3d g = w.scene.domain.gravity;
  const double half = 0.5 * dt;
  const bool clamps = p.clamped.active, sleeps = p.sleep.active;
  const double lessFast = 1.0 / w.clock.substeps - 1;
  const double far2 = w.grid.support * w.grid.support / (dt * dt);
  bool finite = true;
  double fastest = 0, hardest = 0;
  const bool fast = p.fastAcceleration.active;
  recordImpulses(w.ledger, w.scene, half);
  const Vec3d* const force = p.force.data();
  std::size_t behind = p.owned;  // rows from here on are done
  const auto rest = [&](std::size_t from) {
    std::fill(p.acceleration.data() + from, p.acceleration.data() + behind, Vec3d{});
  };
  for (std::size_t k = rows.size(); k-- > 0; behind = rows[k].begin) {
    rest(rows[k].end);
    for (std::size_t i = rows[k].end; i-- > rows[k].begin;) {
      const bool clamped = clamps && p.clamped[i];
      const Vec3d x = p.position[i];
      Vec3d v = p.velocity[i], a = force[i] * (1 / p.mass[i]) + g;
      if (clamped || (sleeps && p.sleep[i] != awake)) a = {};
      if (!std::isfinite(a.x + a.y + a.z + x.x + x.y + x.z + v.x + v.y + v.z)) {
        finite = false;
        *bad = i;
      }
      p.acceleration[i] = a;
      v += a * half;
      if (lessFast != 0 && !clamped) v += p.fastAcceleration[i] * (lessFast * half);
      p.velocity[i] = v;
      const double speed2 = dot(v, v);
      if (speed2 > far2) {  // only a fixed step can be that long, since the speed limit prevents it otherwise
        finite = false;
        *bad = i;
      }
      p.dissipated[i] += p.dissipation[i] * dt;
      fastest = std::max(fastest, speed2);
      if (fast && !clamped) a -= p.fastAcceleration[i];
      hardest = std::max(hardest, dot(a, a));
    }
  }
  rest(0);
  *largest = {fastest, hardest};
  return finite;
}

}  // namespace thaw
