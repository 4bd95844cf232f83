// SPDX-License-Identifier: Apache-2.0
// FIRE (Bitzek, Koskinen, Gaehler, Moseler, Gumbsch 2006): dynamics whose velocity is turned toward the
// force, and reset when the power is negative.
#include "core/simulation/setup/relax_oriented.hpp"

#include <algorithm>
#include <cmath>

#include "core/oriented/forces/anchors.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/population/adaptive_sampling.hpp"
#include "core/oriented/population/follow_interpolant.hpp"
#include "core/oriented/population/redistribute_oriented.hpp"
#include "core/simulation/body_types/redistribute.hpp"
#include "core/simulation/world/views.hpp"

namespace thaw {
namespace {

constexpr double restForce = 1e-9;  // in units of stiffness times spacing
constexpr int patience = 5;

struct Sums {
  double power, force, speed;
};

Sums sumsOf(const Oriented& o, const std::vector<Vec3d>& f, const std::vector<Vec3d>& torque, Reducer& all) {
  ExactSum sum[3];
  for (std::size_t i = 0; i < o.owned; i++) {
    const double m = o.mass[i], inertia = o.inertia[i];
    sum[0].add(dot(f[i], o.velocity[i]) + dot(torque[i], o.spin[i]));
    sum[1].add(dot(f[i], f[i]) / m + dot(torque[i], torque[i]) / inertia);
    sum[2].add(m * dot(o.velocity[i], o.velocity[i]) + inertia * dot(o.spin[i], o.spin[i]));
  }
  std::array<std::int64_t, 3 * ExactSum::digits> digits;
  for (std::size_t k = 0; k < 3; k++) {
    sum[k].carry();
    std::copy(sum[k].digit.begin(), sum[k].digit.end(),
              digits.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits));
  }
  all.sum(digits);
  for (std::size_t k = 0; k < 3; k++)
    std::copy_n(digits.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits), ExactSum::digits,
                sum[k].digit.begin());
  return {sum[0].value(), sum[1].value(), sum[2].value()};
}

}  // namespace

std::int64_t relaxOriented(World& w, Halos halos, StepTools& t) {
  const OrientedView view = orientedView(w, t);
  Oriented& o = w.oriented.rows;
  const auto iterationsOf = [&](const OrientedBody& b) { return std::max(b.relax, t.oriented.relaxAtLeast); };
  std::int64_t most = 0;
  bool grows = false;
  for (const OrientedBody& b : w.scene.oriented) {
    most = std::max(most, iterationsOf(b));
    grows = grows || b.growth != OrientedGrowth::None || b.crowd > 0;
  }
  if (most == 0) return 0;
  bool given = false;
  for (const PointInterpolant& g : t.oriented.given) given = given || !g.points.empty();
  const Vec3d g = w.scene.domain.gravity;
  std::vector<Vec3d> force, torque;
  for (std::size_t i = 0; i < o.owned; i++) o.velocity[i] = o.spin[i] = {};
  double alpha = 0.1, share = 1, dt = 0;
  int good = 0;
  std::int64_t done = 0;
  const std::int64_t stepBefore = w.clock.step;
  std::int64_t calm = 0;  // consecutive checks of the population without a change
  const auto countRows = [&] {
    t.oriented.relaxing = static_cast<std::int64_t>(o.owned);
    halos.all.sum({&t.oriented.relaxing, 1});
  };
  t.oriented.relaxProgress = {};
  countRows();
  for (; done < most; done++) {
    redistributeBodyTypes(w, halos, t);
    updateNeighbours(w.oriented, w.scene, halos, t.oriented.lists);
    w.clock.step = done;  // hashes of births use the step
    if (grows && done % 10 == 0) {
      std::int64_t lost = given ? projectRowsOnInterpolant(view) : 0;
      halos.all.sum({&lost, 1});
      if (lost > 0) redistributeAndUpdate(view, halos);
      const bool changed = adaptSampling(view, halos, 0);
      if (changed) redistributeAndUpdate(view, halos);
      calm = changed || lost > 0 ? 0 : calm + 1;
      if (calm == 0) countRows();
    }
    t.oriented.time = w.clock.time;
    sumOrientedForces(view);
    force.assign(o.owned, {});
    torque.assign(o.owned, {});
    double worst[3] = {0, 0, 0};  // largest force, largest stiffness, stop request
    for (std::size_t i = 0; i < o.owned; i++) {
      const OrientedBody& body = w.scene.oriented[o.body[i]];
      if (!(o.flags[i] & fixedPosition) && iterationsOf(body) > 0) force[i] = o.force[i] + o.mass[i] * g;
      if (!(o.flags[i] & fixedOrientation) && iterationsOf(body) > 0) torque[i] = o.torque[i];
    }
    if (given) addInterpolantForces(o, t.oriented, w.scene, force, torque);
    for (std::size_t i = 0; i < o.owned; i++) {
      const OrientedBody& body = w.scene.oriented[o.body[i]];
      const double unit = body.stiffness * t.oriented.potentials[o.body[i]].spacing;
      worst[0] = std::max({worst[0], length(force[i]) / unit,
                           length(torque[i]) / (unit * t.oriented.potentials[o.body[i]].spacing)});
      worst[1] = std::max(worst[1], o.stiffness[i]);
    }
    if (t.oriented.stopRelaxing && t.oriented.stopRelaxing(done)) worst[2] = 1;
    halos.all.maximum(worst);
    t.oriented.unrest = worst[0];
    t.oriented.atRest = (worst[0] < restForce && (!grows || calm >= 3)) || !(worst[1] > 0);
    t.oriented.relaxStopped = !t.oriented.atRest && worst[2] > 0;
    // births and deaths may disturb the surface forever; with a constant population the force converges,
    // however slowly
    t.oriented.relaxStalled = grows && !t.oriented.atRest && !t.oriented.relaxStopped &&
                              !makesProgress(t.oriented.relaxProgress, done, worst[0], t.oriented.relaxing);
    if (t.oriented.atRest || t.oriented.relaxStopped || t.oriented.relaxStalled) break;
    const Sums s = sumsOf(o, force, torque, halos.all);
    if (s.power > 0) {
      const double mix = alpha * std::sqrt(s.speed / std::max(s.force, 1e-300));
      for (std::size_t i = 0; i < o.owned; i++) {
        o.velocity[i] = (1 - alpha) * o.velocity[i] + (mix / o.mass[i]) * force[i];
        o.spin[i] = (1 - alpha) * o.spin[i] + (mix / o.inertia[i]) * torque[i];
      }
      if (++good > patience) {
        share = std::min(share * 1.1, 6.0);
        alpha *= 0.99;
      }
    } else {
      for (std::size_t i = 0; i < o.owned; i++) o.velocity[i] = o.spin[i] = {};
      share *= 0.5;
      alpha = 0.1;
      good = 0;
    }
    // the bound of the stiffness is conservative: FIRE adapts the step to it
    dt = std::max(share, 0.05) * 0.5 / std::sqrt(worst[1]);
    for (std::size_t i = 0; i < o.owned; i++) {
      const double s0 = t.oriented.potentials[o.body[i]].spacing;
      o.velocity[i] += (dt / o.mass[i]) * force[i];
      o.spin[i] += (dt / o.inertia[i]) * torque[i];
      const double fast = length(o.velocity[i]) * dt, turn = length(o.spin[i]) * dt;
      if (fast > 0.04 * s0) o.velocity[i] = o.velocity[i] * (0.04 * s0 / fast);
      if (turn > 0.1) o.spin[i] = o.spin[i] * (0.1 / turn);
      if (!(o.flags[i] & fixedPosition)) o.position[i] += dt * o.velocity[i];
      if (!(o.flags[i] & fixedOrientation))
        o.orientation[i] = unitQuat(rotationBy(dt * o.spin[i]) * o.orientation[i]);
    }
  }
  w.clock.step = stepBefore;
  for (std::size_t i = 0; i < o.owned; i++) {
    o.velocity[i] = w.scene.oriented[o.body[i]].velocity;
    o.spin[i] = {};
  }
  return done;
}

}  // namespace thaw
