// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/oriented/forces/fields.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/integrators/integrators.hpp"

namespace thaw {

void stepSymplectic(const OrientedView& w, double dt) {
  Oriented& o = w.oriented.rows;
  recordObstacleWork(w, dt);
  w.work.acting.assign(o.force.data(), o.force.data() + o.owned);
  w.work.actingTorque.assign(o.torque.data(), o.torque.data() + o.owned);
  const Vec3d g = w.scene.domain.gravity;
  for (std::size_t i = 0; i < o.owned; i++) {
    const OrientedBody& body = w.scene.oriented[o.body[i]];
    // A force does work over half of the displacement before it and half of the displacement after it. The
    // kick gives F . (v + v') dt' / 2, but the displacement before was v dt. The difference is the scheme's
    // error for a changing step.
    const double change = 0.5 * (dt - w.clock.stepDt);
    if (!(o.flags[i] & fixedPosition)) {
      // contacts with other body types have the impulse of both halves already
      const Vec3d before = o.velocity[i], field = fieldForce(w, i).force,
                  contact = o.external.active ? o.external[i] : Vec3d{};
      o.dissipated[i] -= change * dot(o.force[i] - field - contact + o.mass[i] * g, before);
      // in a steady state, damping between two half kicks dissipates exactly the work of the forces
      const Vec3d kick = (0.5 * dt) * (o.force[i] / o.mass[i] + g);
      Vec3d v = o.velocity[i] + kick;
      const double kept = std::exp(-body.damping * dt);
      o.dissipated[i] += 0.5 * o.mass[i] * dot(v, v) * (1 - kept * kept);
      for (int a = 0; a < 3 && kept < 1; a++)
        if (const double lost = o.mass[i] * v[a] * (kept - 1); lost != 0) w.ledger.wallImpulse[a].add(lost);
      v = v * kept + kick;
      if (const double work = 0.5 * dt * dot(field, before + v); work != 0) w.ledger.wallWork.add(work);
      o.velocity[i] = v;
      o.position[i] += dt * v;
    }
    if (!(o.flags[i] & fixedOrientation)) {
      const Vec3d kick = (0.5 * dt / o.inertia[i]) * o.torque[i];
      o.dissipated[i] -= change * dot(o.torque[i], o.spin[i]);
      Vec3d spin = o.spin[i] + kick;
      const double kept = std::exp(-body.spinDamping * dt);
      o.dissipated[i] += 0.5 * o.inertia[i] * dot(spin, spin) * (1 - kept * kept);
      spin = spin * kept + kick;
      o.spin[i] = spin;
      o.orientation[i] = unitQuat(rotationBy(dt * spin) * o.orientation[i]);
    }
  }
}

}  // namespace thaw
