// SPDX-License-Identifier: Apache-2.0
// FIRE (B06): dynamics in which velocities are turned towards the forces, and reset when the power is
// negative.
#include "core/simulation/setup/relax_oriented.hpp"

#include <algorithm>
#include <cmath>

#include "core/oriented/adaptive_sampling/adaptive_sampling.hpp"
#include "core/oriented/adaptive_sampling/follow_interpolant.hpp"
#include "core/oriented/adaptive_sampling/redistribute_oriented.hpp"
#include "core/oriented/forces/constraints.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/simulation/body_types/redistribute_body_types.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {
namespace {

constexpr double restForce = 1e-9;  // in units of stiffness times spacing
constexpr int downhillSteps = 5;

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

/// Settings of the relaxation of all bodies together.
struct RelaxationPlan {
  std::int64_t iterations = 0;
  bool grows = false;         ///< with births and deaths
  bool interpolates = false;  ///< a body follows its interpolant
};

std::int64_t iterationsOf(const OrientedBody& b, const OrientedWork& work) {
  return std::max(b.relax, work.relaxAtLeast);
}

RelaxationPlan planRelaxation(const Scene& scene, const OrientedWork& work) {
  RelaxationPlan plan;
  for (const OrientedBody& b : scene.oriented) {
    plan.iterations = std::max(plan.iterations, iterationsOf(b, work));
    plan.grows = plan.grows || b.growth != OrientedGrowth::None || b.removalDistance > 0;
  }
  for (const PointInterpolant& g : work.given) plan.interpolates = plan.interpolates || !g.points.empty();
  return plan;
}

void countRows(const OrientedView& view, Reducer& all) {
  view.work.relaxing = static_cast<std::int64_t>(view.oriented.rows.owned);
  all.sum({&view.work.relaxing, 1});
}

/// Removes particles that left their interpolant, and adapts sampling. Returns whether the population
/// changed. Collective.
bool changePopulation(const OrientedView& view, Halos halos, bool interpolates) {
  std::int64_t lost = interpolates ? projectRowsOnInterpolant(view) : 0;
  halos.all.sum({&lost, 1});
  if (lost > 0) redistributeAndUpdate(view, halos);
  const bool changed = adaptSampling(view, halos, 0);
  if (changed) redistributeAndUpdate(view, halos);
  return changed || lost > 0;
}

/// Forces (N) and torques (N m) on unconstrained owned rows.
struct RelaxationForces {
  std::vector<Vec3d> force, torque;
};

void findForces(const OrientedView& view, bool interpolates, RelaxationForces& found) {
  const Oriented& o = view.oriented.rows;
  const Vec3d g = view.scene.domain.gravity;
  sumOrientedForces(view);
  found.force.assign(o.owned, {});
  found.torque.assign(o.owned, {});
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!(iterationsOf(view.scene.oriented[o.body[i]], view.work) > 0)) continue;
    if (!(o.flags[i] & fixedPosition)) found.force[i] = o.force[i] + o.mass[i] * g;
    if (!(o.flags[i] & fixedOrientation)) found.torque[i] = o.torque[i];
  }
  if (interpolates) addInterpolantForces(o, view.work, view.scene, found.force, found.torque);
}

/// Largest values over all ranks.
struct Residual {
  double force;      ///< 1, over stiffness times spacing
  double stiffness;  ///< 1/s^2
  bool stop;         ///< a rank requests a stop
};

/// Collective. done: number of iterations.
Residual findResidual(const OrientedView& view, const RelaxationForces& f, std::int64_t done, Reducer& all) {
  const Oriented& o = view.oriented.rows;
  double largest[3] = {0, 0, 0};
  for (std::size_t i = 0; i < o.owned; i++) {
    const double spacing = view.work.potentials[o.body[i]].spacing,
                 unit = view.scene.oriented[o.body[i]].stiffness * spacing;
    largest[0] = std::max({largest[0], length(f.force[i]) / unit, length(f.torque[i]) / (unit * spacing)});
    largest[1] = std::max(largest[1], o.stiffness[i]);
  }
  if (view.work.stopRelaxing && view.work.stopRelaxing(done)) largest[2] = 1;
  all.maximum(largest);
  return {largest[0], largest[1], largest[2] > 0};
}

/// Step control of FIRE.
struct Fire {
  double mixing = 0.1;    ///< fraction of the velocity that turns toward the force
  double stepFactor = 1;  ///< step divided by half the stable step
  int positive = 0;       ///< iterations since the power was negative

  double step(double stiffness) const {  // s
    // The bound of the stiffness is conservative, so FIRE adapts the step.
    return std::max(stepFactor, 0.05) * 0.5 / std::sqrt(stiffness);
  }
};

/// Turns velocities toward the forces, or stops all rows if the power is negative. Collective.
void steer(Oriented& o, const RelaxationForces& f, Fire& fire, Reducer& all) {
  const Sums s = sumsOf(o, f.force, f.torque, all);
  if (!(s.power > 0)) {
    for (std::size_t i = 0; i < o.owned; i++) o.velocity[i] = o.spin[i] = {};
    fire.stepFactor *= 0.5;
    fire.mixing = 0.1;
    fire.positive = 0;
    return;
  }
  const double mix = fire.mixing * std::sqrt(s.speed / std::max(s.force, 1e-300));
  for (std::size_t i = 0; i < o.owned; i++) {
    o.velocity[i] = (1 - fire.mixing) * o.velocity[i] + (mix / o.mass[i]) * f.force[i];
    o.spin[i] = (1 - fire.mixing) * o.spin[i] + (mix / o.inertia[i]) * f.torque[i];
  }
  if (++fire.positive > downhillSteps) {
    fire.stepFactor = std::min(fire.stepFactor * 1.1, 6.0);
    fire.mixing *= 0.99;
  }
}

/// Symplectic Euler with bounded moves and turns. dt: s.
void moveRows(const OrientedView& view, const RelaxationForces& f, double dt) {
  constexpr double longestMove = 0.04, largestTurn = 0.1;  // spacings; rad
  Oriented& o = view.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) {
    const double longest = longestMove * view.work.potentials[o.body[i]].spacing;
    o.velocity[i] += (dt / o.mass[i]) * f.force[i];
    o.spin[i] += (dt / o.inertia[i]) * f.torque[i];
    const double move = length(o.velocity[i]) * dt, turn = length(o.spin[i]) * dt;
    if (move > longest) o.velocity[i] = o.velocity[i] * (longest / move);
    if (turn > largestTurn) o.spin[i] = o.spin[i] * (largestTurn / turn);
    if (!(o.flags[i] & fixedPosition)) o.position[i] += dt * o.velocity[i];
    if (!(o.flags[i] & fixedOrientation))
      o.orientation[i] = unitQuat(rotationBy(dt * o.spin[i]) * o.orientation[i]);
  }
}

}  // namespace

std::int64_t relaxOriented(World& w, Halos halos, StepTools& t) {
  const OrientedView view = orientedView(w, t);
  Oriented& o = w.oriented.rows;
  OrientedWork& work = t.oriented;
  const RelaxationPlan plan = planRelaxation(w.scene, work);
  if (plan.iterations == 0) return 0;
  const std::int64_t stepBefore = w.clock.step;
  RelaxationForces forces;
  Fire fire;
  std::int64_t done = 0, unchanged = 0;  // consecutive checks of the population without a change
  for (std::size_t i = 0; i < o.owned; i++) o.velocity[i] = o.spin[i] = {};
  work.relaxProgress = {};
  countRows(view, halos.all);
  for (; done < plan.iterations; done++) {
    redistributeBodyTypes(w, halos, t.redistribution);
    updateNeighbours(w.oriented, w.scene, halos, work.lists);
    w.clock.step = done;  // hashes of births use the step
    if (plan.grows && done % 10 == 0) {
      unchanged = changePopulation(view, halos, plan.interpolates) ? 0 : unchanged + 1;
      if (unchanged == 0) countRows(view, halos.all);
    }
    work.time = w.clock.time;
    findForces(view, plan.interpolates, forces);
    const Residual residual = findResidual(view, forces, done, halos.all);
    work.residualForce = residual.force;
    work.atRest = (residual.force < restForce && (!plan.grows || unchanged >= 3)) ||
                  !(residual.stiffness > 0);
    work.relaxStopped = !work.atRest && residual.stop;
    // Births and deaths may disturb the surface forever. With constant sampling the force converges, possibly
    // slowly.
    work.relaxStalled = plan.grows && !work.atRest && !work.relaxStopped &&
                        !makesProgress(work.relaxProgress, done, residual.force, work.relaxing);
    if (work.atRest || work.relaxStopped || work.relaxStalled) break;
    steer(o, forces, fire, halos.all);
    moveRows(view, forces, fire.step(residual.stiffness));
  }
  w.clock.step = stepBefore;
  for (std::size_t i = 0; i < o.owned; i++) {
    o.velocity[i] = w.scene.oriented[o.body[i]].velocity;
    o.spin[i] = {};
  }
  return done;
}

}  // namespace thaw
