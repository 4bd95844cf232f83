#include "core/oriented/step_oriented.hpp"

#include <algorithm>
#include <cmath>

#include "core/domain/sides.hpp"
#include "core/kinds/place_kinds.hpp"
#include "core/oriented/held.hpp"
#include "core/oriented/integrators.hpp"
#include "core/oriented/operations.hpp"
#include "core/oriented/oriented_forces.hpp"
#include "core/oriented/population.hpp"
#include "core/oriented/prepare_oriented.hpp"

namespace thaw {
namespace {

/// What an anchor has to give its particle: change of momentum and energy less what the other forces do. Before and after the move of it.
struct HeldBooks {
  World& w;
  double dt;
  std::vector<Vec3d> velocity, place;
  std::vector<std::uint8_t> flags;  // an anchor may let go at the end of the step that it still held
  explicit HeldBooks(World& world, double step) : w(world), dt(step) {
    const Oriented& o = w.oriented.rows;
    velocity.assign(o.velocity.data(), o.velocity.data() + o.owned);
    place.assign(o.position.data(), o.position.data() + o.owned);
    flags.assign(o.flags.data(), o.flags.data() + o.owned);
  }
  void close(const std::vector<Vec3d>& acting) {
    const Oriented& o = w.oriented.rows;
    for (std::size_t i = 0; i < o.owned; i++) {
      if (!(flags[i] & heldPlace)) continue;
      const Vec3d force = acting[i] + o.mass[i] * w.scene.domain.gravity, impulse = o.mass[i] * (o.velocity[i] - velocity[i]) - dt * force;
      for (int a = 0; a < 3; a++)
        if (impulse[a] != 0) w.ledger.wallImpulse[a].add(impulse[a]);
      // these forces act over half of the way before and half of the way after them (trapezoids); the implicit ones change in proportion to the way of the step
      const bool implicit = w.scene.oriented.front().integrator == OrientedIntegrator::SemiImplicit;
      const Vec3d now = o.position[i] - place[i], way = implicit ? now : 0.5 * (now + w.clock.stepDt * velocity[i]), pull = implicit ? force + 0.5 * (o.force[i] - acting[i]) : force;
      const double work = 0.5 * o.mass[i] * (dot(o.velocity[i], o.velocity[i]) - dot(velocity[i], velocity[i])) - dot(pull, way);
      if (work != 0) w.ledger.wallWork.add(work);
    }
  }
};

/// Adds the rows' energy to what changes without work: `sign` 1 before the change, -1 after it. Symplectic Euler gives a force the half of the way of the step
/// (dt) that led to it only with the next kick (symplectic.cpp): that of a force that is another one by then belongs to the change.
void bookEnergy(World& w, const StepTools& t, double sign, double dt) {
  const Oriented& o = w.oriented.rows;
  const double half = w.scene.oriented.front().integrator == OrientedIntegrator::SymplecticEuler ? 0.5 * dt : 0;
  for (std::size_t i = 0; i < o.owned; i++) w.ledger.phaseJump.add(sign * (o.energy[i] + half * (dot(o.force[i] - fieldOn(w, t, i), o.velocity[i]) + dot(o.torque[i], o.spin[i]))));
}

/// Has a row of any rank come through an open side? Collective, where there is one.
bool anyLeaves(const World& w, Reducer& all) {
  if (!hasOpenSide(w.scene.domain)) return false;
  const Oriented& o = w.oriented.rows;
  double gone = 0;
  for (std::size_t i = 0; i < o.owned; i++) gone = std::max(gone, isOutside(w.scene.domain, o.position[i]) ? 1.0 : 0.0);
  all.maximum({&gone, 1});
  return gone > 0;
}

void letGoOutside(World& w) {
  const Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++)
    if (isOutside(w.scene.domain, o.position[i])) {
      letGo(w, i);
      w.counters.left++;
    }
}

/// Has a free row come further from its place of before than what it acts on? Before any of them can leave the domain unseen.
bool goesTooFar(const World& w, const std::vector<Vec3d>& before) {
  const Oriented& o = w.oriented.rows;
  const double reach = orientedReach(w.scene), reach2 = reach * reach;
  for (std::size_t i = 0; i < o.owned; i++) {
    const Vec3d way = o.position[i] - before[i];
    if (!(o.flags[i] & heldPlace) && !(dot(way, way) < reach2)) return true;
  }
  return false;
}

}  // namespace

void stepOriented(World& w, Halos halos, StepTools& t, double dt) {
  HeldBooks held(w, dt);
  // one integrator for all bodies: pairs may be of two
  const OrientedIntegrator how = w.scene.oriented.front().integrator;
  if (how == OrientedIntegrator::RungeKutta) stepRungeKutta(w, halos, t, dt);
  else if (how == OrientedIntegrator::SemiImplicit) stepSemiImplicit(w, halos, t, dt);
  else stepSymplectic(w, t, dt);
  w.oriented.overran = goesTooFar(w, held.place);
  moveHeld(w, w.clock.time + dt, dt);
  held.close(t.oriented.acting);
  t.times.lap(StepPhase::Oriented);
}

void evaluateOriented(World& w, Halos halos, StepTools& t, double dt) {
  Oriented& o = w.oriented.rows;
  const double now = w.clock.time + dt;  // a step's clock still shows its beginning here
  readyOriented(w, halos, t);
  const bool events = operationDue(w.scene, w.clock.time, now, dt), look = populationDue(w, dt), leaves = dt > 0 && anyLeaves(w, halos.all);
  if (events || look || leaves) {
    addUpForces(w, t);
    if (dt > 0) bookEnergy(w, t, 1, dt);
    if (leaves) {
      letGoOutside(w);
      readyAgain(w, halos, t);
    }
    if (events) {
      operate(w, halos, t, dt > 0 ? w.clock.time : -never, now);
      readyAgain(w, halos, t);
    }
    if (look && changePopulation(w, halos, t)) readyAgain(w, halos, t);
    addUpForces(w, t);
    if (dt > 0) bookEnergy(w, t, -1, dt);
  } else {
    addUpForces(w, t);
  }
  if (o.external.active) {
    // contacts with other kinds follow in this evaluation; the forces so far held those of the last one
    for (std::size_t i = 0; i < o.owned; i++) {
      o.force[i] -= o.external[i];
      o.external[i] = {};
    }
  }
  t.times.lap(StepPhase::Oriented);
}

double orientedStepLimit(const World& w, const StepTools& t) {
  const Oriented& o = w.oriented.rows;
  double dt = t.oriented.fastest2 > 0 ? 0.5 / std::sqrt(t.oriented.fastest2) : never;
  for (std::size_t i = 0; i < o.owned; i++) {
    const OrientedBody& body = w.scene.oriented[o.body[i]];
    const double s = body.spacing > 0 ? body.spacing : w.scene.spacing;
    const double stable = body.integrator == OrientedIntegrator::SymplecticEuler ? 2 : body.integrator == OrientedIntegrator::RungeKutta ? 2.8 : 20;
    if (o.stiffness[i] > 0) dt = std::min(dt, body.cfl * stable / std::sqrt(o.stiffness[i]));
    const double speed = length(o.velocity[i]), pull = length(o.force[i]) / o.mass[i];
    if (speed > 0) dt = std::min(dt, 0.1 * s / speed);
    if (pull > 0) dt = std::min(dt, std::sqrt(0.1 * s / pull));
  }
  return dt;
}

}  // namespace thaw
