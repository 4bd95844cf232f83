// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/forces/constraint_work.hpp"

namespace thaw {

StateBefore stateBefore(const Oriented& o, double dt) {
  const auto copy = [&](const auto& column, auto& to) { to.assign(column.data(), column.data() + o.owned); };
  StateBefore b;
  b.dt = dt;
  copy(o.velocity, b.velocity);
  copy(o.position, b.place);
  copy(o.spin, b.spin);
  copy(o.orientation, b.turn);
  copy(o.flags, b.flags);
  return b;
}

void recordConstraintWork(const OrientedView& w, const StateBefore& b, double weight) {
  const Oriented& o = w.oriented.rows;
  const OrientedWork& t = w.work;
  // A force acts over half of the displacement before it and half of the displacement after it (trapezoidal
  // rule). Implicit forces vary linearly over the step.
  const bool implicit = w.scene.oriented.front().integrator == OrientedIntegrator::SemiImplicit;
  const auto wayOf = [&](const Vec3d& now, const Vec3d& rateBefore) {
    return implicit ? now : 0.5 * (now + w.clock.stepDt * rateBefore);
  };
  const auto pullOf = [&](const Vec3d& acting, const Vec3d& first) {
    return implicit ? 0.5 * (acting + first) : acting;
  };
  for (std::size_t i = 0; i < o.owned; i++) {
    double work = 0;
    if (b.flags[i] & fixedPosition) {
      const Vec3d weightForce = o.mass[i] * w.scene.domain.gravity,
                  impulse = o.mass[i] * (o.velocity[i] - b.velocity[i]) - b.dt * (t.acting[i] + weightForce);
      for (int a = 0; a < 3; a++)
        if (impulse[a] != 0) w.ledger.wallImpulse[a].add(impulse[a]);
      // external is scaled by `weight`, because its impulse covers halves of two steps
      const Vec3d contact = o.external.active ? (1 - 1 / weight) * o.external[i] : Vec3d{};
      work += 0.5 * o.mass[i] * (dot(o.velocity[i], o.velocity[i]) - dot(b.velocity[i], b.velocity[i])) -
              dot(pullOf(t.acting[i], o.force[i]) + weightForce - contact,
                  wayOf(o.position[i] - b.place[i], b.velocity[i]));
    }
    if (b.flags[i] & fixedOrientation)
      work += 0.5 * o.inertia[i] * (dot(o.spin[i], o.spin[i]) - dot(b.spin[i], b.spin[i])) -
              dot(pullOf(t.actingTorque[i], o.torque[i]),
                  wayOf(turnBetween(b.turn[i], o.orientation[i]), b.spin[i]));
    if (work != 0) w.ledger.wallWork.add(work);
  }
}

}  // namespace thaw
