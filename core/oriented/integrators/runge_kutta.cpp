// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/integrators/integrators.hpp"

namespace thaw {
namespace {

Quat sum(const Quat& a, double f, const Quat& b) {
  return {a.w + f * b.w, a.x + f * b.x, a.y + f * b.y, a.z + f * b.z};
}

}  // namespace

void stepRungeKutta(const OrientedView& w, Halos halos, double dt) {
  Oriented& o = w.oriented.rows;
  OrientedWork& work = w.work;
  const Vec3d g = w.scene.domain.gravity;
  const std::size_t n = o.owned;
  const auto copy = [&](auto& column, auto& to) { to.assign(column.data(), column.data() + n); };
  copy(o.position, work.place);
  copy(o.orientation, work.turn);
  copy(o.velocity, work.velocity);
  copy(o.spin, work.spin);
  work.sumVelocity.assign(n, {});
  work.sumSpin.assign(n, {});
  work.sumForce.assign(n, {});
  work.sumTorque.assign(n, {});
  work.acting.assign(n, {});
  work.actingTorque.assign(n, {});
  std::vector<Quat> sumTurn(n, Quat{0, 0, 0, 0});
  constexpr double share[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, next[4] = {0.5, 0.5, 1, 0};
  for (int stage = 0; stage < 4; stage++) {
    if (stage > 0) {
      findNormals(o);
      refreshGhostPoses(o, halos);
      work.time = w.clock.time + next[stage - 1] * dt;
      sumOrientedForces(w);
    }
    recordObstacleWork(w, share[stage] * dt);
    for (std::size_t i = 0; i < n; i++) {
      const OrientedBody& body = w.scene.oriented[o.body[i]];
      const bool place = !(o.flags[i] & fixedPosition), turns = !(o.flags[i] & fixedOrientation);
      const Vec3d v = o.velocity[i], spin = o.spin[i];
      const Vec3d a = place ? o.force[i] / o.mass[i] + g - body.damping * v : Vec3d{},
                  turn = turns ? o.torque[i] / o.inertia[i] - body.spinDamping * spin : Vec3d{};
      const Quat q = o.orientation[i],
                 rate = turns ? Quat{0, 0.5 * spin.x, 0.5 * spin.y, 0.5 * spin.z} * q : Quat{0, 0, 0, 0};
      work.acting[i] += share[stage] * o.force[i];
      work.actingTorque[i] += share[stage] * o.torque[i];
      work.sumVelocity[i] += share[stage] * v;
      work.sumForce[i] += share[stage] * a;
      work.sumSpin[i] += share[stage] * spin;
      work.sumTorque[i] += share[stage] * turn;
      sumTurn[i] = sum(sumTurn[i], share[stage], rate);
      if (place) o.dissipated[i] += share[stage] * dt * body.damping * o.mass[i] * dot(v, v);
      if (turns) o.dissipated[i] += share[stage] * dt * body.spinDamping * o.inertia[i] * dot(spin, spin);
      if (place)
        for (int k = 0; k < 3; k++)
          if (const double lost = -share[stage] * dt * body.damping * o.mass[i] * v[k]; lost != 0)
            w.ledger.wallImpulse[k].add(lost);
      const double h = next[stage] * dt;
      if (stage == 3) continue;
      if (place) {
        o.position[i] = work.place[i] + h * v;
        o.velocity[i] = work.velocity[i] + h * a;
      }
      if (turns) {
        o.orientation[i] = unitQuat(sum(work.turn[i], h, rate));
        o.spin[i] = work.spin[i] + h * turn;
      }
    }
  }
  for (std::size_t i = 0; i < n; i++) {
    if (!(o.flags[i] & fixedPosition)) {
      o.position[i] = work.place[i] + dt * work.sumVelocity[i];
      o.velocity[i] = work.velocity[i] + dt * work.sumForce[i];
    }
    if (!(o.flags[i] & fixedOrientation)) {
      o.orientation[i] = unitQuat(sum(work.turn[i], dt, sumTurn[i]));
      o.spin[i] = work.spin[i] + dt * work.sumTorque[i];
    }
  }
}

}  // namespace thaw
