// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/step_oriented.hpp"

#include <algorithm>
#include <cmath>

#include "core/domain/sides.hpp"
#include "core/oriented/adaptive_sampling/adaptive_sampling.hpp"
#include "core/oriented/adaptive_sampling/events.hpp"
#include "core/oriented/adaptive_sampling/redistribute_oriented.hpp"
#include "core/oriented/forces/constraint_work.hpp"
#include "core/oriented/forces/constraints.hpp"
#include "core/oriented/forces/fields.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/integrators/integrators.hpp"
#include "core/oriented/laws/oriented_reach.hpp"

namespace thaw {
namespace {

constexpr double perObstacle = 0.5;  // rad, phase per step at obstacle barriers

// Phase (rad) per step of contacts. Their force grows with the cube of depth. With twice this value, a
// pressed surface gains 1 % of its energy.
constexpr double perContact = 0.25;

/// Records a change of the rows' energy without work. sign: 1 before the change, -1 after it.
void recordEnergyJump(const OrientedView& w, double sign, double dt) {
  const Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) w.ledger.phaseJump.add(sign * o.energy[i]);
  recordKickLag(w, sign, dt, w.ledger.phaseJump);
}

/// Scales the contact forces with other body types to half of the last step plus half of the next step of dt
/// (s). The other bodies integrate the same force by leap-frog, so they get the same impulse. Returns the
/// scale.
double scaleContacts(Oriented& o, const Clock& clock, double dt) {
  const double weight = 0.5 * (clock.stepDt + dt) / dt;
  for (std::size_t i = 0; i < o.owned && o.external.active; i++) {
    const Vec3d weighed = weight * o.external[i];
    o.force[i] += weighed - o.external[i];
    o.external[i] = weighed;
  }
  return weight;
}

/// Records dissipation of contacts with other body types, and the integrator's error for their force E. E
/// acts over half of the displacement before it (s v, step s) and half of the displacement after it (d v',
/// step d). Its impulse E (s + d)/2 does the work E (s + d)/2 . (v + v')/2. If the scheme's loss assumes the
/// new velocity, the work is E (s + d)/2 . v'.
void recordContactWork(const OrientedView& w, const StateBefore& before, double weight) {
  Oriented& o = w.oriented.rows;
  if (!o.external.active) return;
  const double s = w.clock.stepDt, d = before.dt;
  const double share = w.scene.oriented.front().integrator == OrientedIntegrator::SemiImplicit
                           ? 0.5 * s
                           : 0.25 * (s - d);
  for (std::size_t i = 0; i < o.owned; i++) {
    const Vec3d v = before.velocity[i], now = o.velocity[i];
    o.dissipated[i] -= 0.5 * dot(o.dissipativeForce[i], s * v + d * now);
    if (!(before.flags[i] & fixedPosition)) o.dissipated[i] -= share / weight * dot(o.external[i], now - v);
  }
}

/// Returns whether a row of any rank has crossed an open side. Collective if the domain has an open side.
bool anyLeaves(const Oriented& o, const Domain& domain, Reducer& all) {
  if (!hasOpenSide(domain)) return false;
  const OpenBox box = openBox(domain);
  double gone = 0;
  for (std::size_t i = 0; i < o.owned; i++) gone = std::max(gone, box.leaves(o.position[i]) ? 1.0 : 0.0);
  all.maximum({&gone, 1});
  return gone > 0;
}

void removeOutside(const OrientedView& w, double dt) {
  const Oriented& o = w.oriented.rows;
  const OpenBox box = openBox(w.scene.domain);
  for (std::size_t i = 0; i < o.owned; i++)
    if (box.leaves(o.position[i])) {
      countLeaving(w.scene.domain, o.position[i], w.counters);
      removeRow(w, i, dt);
    }
}

/// Returns whether a free row moved farther than its interaction radius. Called before rows can leave the
/// domain.
bool exceedsReach(const Oriented& o, const Scene& scene, const std::vector<Vec3d>& before) {
  const double reach = orientedReach(scene), reach2 = reach * reach;
  for (std::size_t i = 0; i < o.owned; i++) {
    const Vec3d way = o.position[i] - before[i];
    if (!(o.flags[i] & fixedPosition) && !(dot(way, way) < reach2)) return true;
  }
  return false;
}

}  // namespace

void stepOriented(const OrientedView& w, Halos halos, double dt) {
  const StateBefore before = stateBefore(w.oriented.rows, dt);
  const double weight = scaleContacts(w.oriented.rows, w.clock, dt);
  w.work.time = w.clock.time;  // time of the forces at the start of the step
  averageFields(w, dt);
  // one integrator for all bodies, since pairs may join two bodies
  const OrientedIntegrator how = w.scene.oriented.front().integrator;
  if (how == OrientedIntegrator::RungeKutta) stepRungeKutta(w, halos, dt);
  else if (how == OrientedIntegrator::SemiImplicit) stepSemiImplicit(w, halos, dt);
  else stepSymplectic(w, dt);
  w.oriented.exceededReach = exceedsReach(w.oriented.rows, w.scene, before.place);
  moveConstrained(w.oriented.rows, w.scene, w.clock.time + dt, dt);
  recordConstraintWork(w, before, weight);
  recordContactWork(w, before, weight);
  w.times.lap(StepPhase::Oriented);
}

void applyPendingImpulse(Oriented& o, Clock& clock, Ledger& ledger) {
  for (std::size_t i = 0; i < o.owned && o.external.active; i++) {
    const Vec3d impulse = (0.5 * clock.stepDt) * o.external[i];
    o.dissipated[i] -= 0.5 * clock.stepDt * dot(o.dissipativeForce[i], o.velocity[i]);
    if (!(o.flags[i] & fixedPosition)) {
      o.velocity[i] += impulse / o.mass[i];
      continue;
    }
    for (int a = 0; a < 3; a++)
      if (impulse[a] != 0) ledger.wallImpulse[a].add(-impulse[a]);
  }
  clock.stepDt = 0;
}

void recordKickLag(const OrientedView& w, double sign, double dt, ExactSum& to) {
  const Oriented& o = w.oriented.rows;
  if (w.scene.oriented.empty() || w.scene.oriented.front().integrator != OrientedIntegrator::SymplecticEuler)
    return;
  for (std::size_t i = 0; i < o.owned; i++) {
    const Vec3d contact = o.external.active ? o.external[i] : Vec3d{};
    to.add(sign * 0.5 * dt *
           (dot(o.force[i] - fieldForce(w, i).force - contact, o.velocity[i]) + dot(o.torque[i], o.spin[i])));
  }
}

void evaluateOriented(const OrientedView& w, Halos halos, double dt) {
  Oriented& o = w.oriented.rows;
  const double now = w.clock.time + dt;  // the clock still shows the beginning of the step
  w.work.time = now;
  w.work.over = 0;
  w.work.born.clear();
  updateNeighbours(w.oriented, w.scene, halos, w.work.lists);
  const double since = w.work.begins ? -never : w.clock.time;
  recordUnusedFields(w, halos.all, since, now);
  const bool events = eventsDue(w.scene, since, now), look = adaptSamplingDue(w.scene, w.clock, dt),
             leaves = dt > 0 && anyLeaves(o, w.scene.domain, halos.all);
  if (events || look || leaves) {
    sumOrientedForces(w);
    if (dt > 0) recordEnergyJump(w, 1, dt);
    if (leaves) {
      removeOutside(w, dt);
      redistributeAndUpdate(w, halos);
    }
    if (events) {
      applyEvents(w, halos, since, now);
      redistributeAndUpdate(w, halos);
    }
    if (look && adaptSampling(w, halos, dt)) redistributeAndUpdate(w, halos);
    sumOrientedForces(w);
    if (dt > 0) recordEnergyJump(w, -1, dt);
    for (std::uint32_t i = 0; i < o.owned; i++) {
      if (!(o.flags[i] & newborn)) continue;
      o.flags[i] = static_cast<std::uint8_t>(o.flags[i] & ~newborn);
      w.work.born.push_back({i, o.energy[i]});
    }
  } else {
    sumOrientedForces(w);
  }
  if (o.external.active) {
    // the forces include contacts of the last evaluation; contacts of this evaluation are added later
    for (std::size_t i = 0; i < o.owned; i++) {
      o.force[i] -= o.external[i];
      o.external[i] = o.dissipativeForce[i] = {};
    }
  }
  w.work.begins = false;
  w.times.lap(StepPhase::Oriented);
}

void recordBirthContacts(const Oriented& o, const OrientedWork& work, Ledger& ledger) {
  // the other half belongs to the other particles
  for (const OrientedWork::Born& b : work.born) ledger.phaseJump.add(-2 * (o.energy[b.row] - b.energy));
}

double orientedStepLimit(const Oriented& o, const Scene& scene, const OrientedWork& work) {
  if (scene.oriented.empty()) return never;
  const OrientedIntegrator how = scene.oriented.front().integrator;  // one integrator for all, as in
                                                                     // stepOriented
  const double stable = how == OrientedIntegrator::SymplecticEuler ? 2
                        : how == OrientedIntegrator::RungeKutta    ? 2.8
                                                                   : 20;
  double dt = work.fastest2 > 0 ? perContact / std::sqrt(work.fastest2) : never;
  // obstacles are explicit in all integrators
  if (work.obstacleFrequency2 > 0) dt = std::min(dt, perObstacle / std::sqrt(work.obstacleFrequency2));
  for (std::size_t i = 0; i < o.owned; i++) {
    const OrientedBody& body = scene.oriented[o.body[i]];
    const double s = spacingOf(scene, body);
    if (o.stiffness[i] > 0) dt = std::min(dt, body.cfl * stable / std::sqrt(o.stiffness[i]));
    const double speed = length(o.velocity[i]), pull = length(o.force[i]) / o.mass[i];
    if (speed > 0) dt = std::min(dt, 0.1 * s / speed);
    if (pull > 0) dt = std::min(dt, std::sqrt(0.1 * s / pull));
  }
  return dt;
}

}  // namespace thaw
