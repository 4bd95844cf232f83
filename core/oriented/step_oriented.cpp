// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/step_oriented.hpp"

#include <algorithm>
#include <cmath>

#include "core/domain/sides.hpp"
#include "core/oriented/forces/anchor_work.hpp"
#include "core/oriented/forces/anchors.hpp"
#include "core/oriented/forces/fields.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/integrators/integrators.hpp"
#include "core/oriented/laws/oriented_reach.hpp"
#include "core/oriented/population/adaptive_sampling.hpp"
#include "core/oriented/population/events.hpp"
#include "core/oriented/prepare_oriented.hpp"
#include "core/simulation/body_types/redistribute.hpp"

namespace thaw {
namespace {

constexpr double perObstacle = 0.5;  // rad, phase per step at obstacle barriers

// Phase (rad) per step of contacts, whose force grows with the cube of depth. Twice the value gains 1 % of
// the energy of a pressed surface.
constexpr double perContact = 0.25;

/// Records the rows' energy as changed without work: `sign` 1 before the change, -1 after it.
void recordEnergyJump(World& w, const StepTools& t, double sign, double dt) {
  const Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) w.ledger.phaseJump.add(sign * o.energy[i]);
  recordKickLag(w, t, sign, dt, w.ledger.phaseJump);
}

/// Scales the contact forces with other body types to half of the last and half of the next step of dt (s).
/// The other ends integrate the same force by leap-frog and get that impulse. Returns the scale.
double scaleContacts(World& w, double dt) {
  Oriented& o = w.oriented.rows;
  const double weight = 0.5 * (w.clock.stepDt + dt) / dt;
  for (std::size_t i = 0; i < o.owned && o.external.active; i++) {
    const Vec3d weighed = weight * o.external[i];
    o.force[i] += weighed - o.external[i];
    o.external[i] = weighed;
  }
  return weight;
}

/// Records dissipation of contacts with other body types, and the error of the integrator for their force E.
/// E acts over half of the displacement before it and half of that after it (s v and d v' for steps s and d).
/// Its impulse E (s + d)/2 does the work E (s + d)/2 . (v + v')/2; if the scheme's loss assumes the new
/// velocity, it is E (s + d)/2 . v'.
void recordContactWork(World& w, const StateBefore& before, double weight) {
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

/// Returns whether a row of any rank has crossed an open side. Collective, if the domain has one.
bool anyLeaves(const World& w, Reducer& all) {
  if (!hasOpenSide(w.scene.domain)) return false;
  const Oriented& o = w.oriented.rows;
  const OpenBox box = openBox(w.scene.domain);
  double gone = 0;
  for (std::size_t i = 0; i < o.owned; i++) gone = std::max(gone, box.leaves(o.position[i]) ? 1.0 : 0.0);
  all.maximum({&gone, 1});
  return gone > 0;
}

void removeOutside(World& w, double dt) {
  const Oriented& o = w.oriented.rows;
  const OpenBox box = openBox(w.scene.domain);
  for (std::size_t i = 0; i < o.owned; i++)
    if (box.leaves(o.position[i])) {
      countLeaving(w.scene.domain, o.position[i], w.counters);
      removeRow(w, i, dt);
    }
}

/// Returns whether a free row moved farther than its interaction radius; tested before it can leave the
/// domain.
bool exceedsReach(const World& w, const std::vector<Vec3d>& before) {
  const Oriented& o = w.oriented.rows;
  const double reach = orientedReach(w.scene), reach2 = reach * reach;
  for (std::size_t i = 0; i < o.owned; i++) {
    const Vec3d way = o.position[i] - before[i];
    if (!(o.flags[i] & fixedPosition) && !(dot(way, way) < reach2)) return true;
  }
  return false;
}

}  // namespace

void stepOriented(World& w, Halos halos, StepTools& t, double dt) {
  const StateBefore held = stateBefore(w, dt);
  const double weight = scaleContacts(w, dt);
  t.oriented.time = w.clock.time;  // time of the forces at the start of the step
  averageFields(w, t.oriented, dt);
  // one integrator for all, since pairs may join two bodies
  const OrientedIntegrator how = w.scene.oriented.front().integrator;
  if (how == OrientedIntegrator::RungeKutta) stepRungeKutta(w, halos, t, dt);
  else if (how == OrientedIntegrator::SemiImplicit) stepSemiImplicit(w, halos, t, dt);
  else stepSymplectic(w, t, dt);
  w.oriented.exceededReach = exceedsReach(w, held.place);
  moveAnchored(w, w.clock.time + dt, dt);
  recordAnchorWork(w, held, t.oriented, weight);
  recordContactWork(w, held, weight);
  t.times.lap(StepPhase::Oriented);
}

void applyPendingImpulse(World& w) {
  Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned && o.external.active; i++) {
    const Vec3d impulse = (0.5 * w.clock.stepDt) * o.external[i];
    o.dissipated[i] -= 0.5 * w.clock.stepDt * dot(o.dissipativeForce[i], o.velocity[i]);
    if (!(o.flags[i] & fixedPosition)) {
      o.velocity[i] += impulse / o.mass[i];
      continue;
    }
    for (int a = 0; a < 3; a++)
      if (impulse[a] != 0) w.ledger.wallImpulse[a].add(-impulse[a]);
  }
  w.clock.stepDt = 0;
}

void recordKickLag(const World& w, const StepTools& t, double sign, double dt, ExactSum& to) {
  const Oriented& o = w.oriented.rows;
  if (w.scene.oriented.empty() || w.scene.oriented.front().integrator != OrientedIntegrator::SymplecticEuler)
    return;
  for (std::size_t i = 0; i < o.owned; i++) {
    const Vec3d contact = o.external.active ? o.external[i] : Vec3d{};
    to.add(sign * 0.5 * dt *
           (dot(o.force[i] - fieldForce(w, t.oriented, i).force - contact, o.velocity[i]) +
            dot(o.torque[i], o.spin[i])));
  }
}

void evaluateOriented(World& w, Halos halos, StepTools& t, double dt) {
  Oriented& o = w.oriented.rows;
  const double now = w.clock.time + dt;  // the clock still shows the beginning of the step
  t.oriented.time = now;
  t.oriented.over = 0;
  t.oriented.born.clear();
  updateNeighbours(w, halos, t);
  const double since = t.oriented.begins ? -never : w.clock.time;
  recordUnusedFields(w, halos.all, t.oriented, since, now);
  const bool events = eventsDue(w.scene, since, now), look = adaptSamplingDue(w, dt),
             leaves = dt > 0 && anyLeaves(w, halos.all);
  if (events || look || leaves) {
    sumOrientedForces(w, t);
    if (dt > 0) recordEnergyJump(w, t, 1, dt);
    if (leaves) {
      removeOutside(w, dt);
      redistributeAndUpdate(w, halos, t);
    }
    if (events) {
      applyEvents(w, halos, t, since, now);
      redistributeAndUpdate(w, halos, t);
    }
    if (look && adaptSampling(w, halos, t, dt)) redistributeAndUpdate(w, halos, t);
    sumOrientedForces(w, t);
    if (dt > 0) recordEnergyJump(w, t, -1, dt);
    for (std::uint32_t i = 0; i < o.owned; i++) {
      if (!(o.flags[i] & newborn)) continue;
      o.flags[i] = static_cast<std::uint8_t>(o.flags[i] & ~newborn);
      t.oriented.born.push_back({i, o.energy[i]});
    }
  } else {
    sumOrientedForces(w, t);
  }
  if (o.external.active) {
    // the forces include contacts of the last evaluation; those of this one are added later
    for (std::size_t i = 0; i < o.owned; i++) {
      o.force[i] -= o.external[i];
      o.external[i] = o.dissipativeForce[i] = {};
    }
  }
  t.oriented.begins = false;
  t.times.lap(StepPhase::Oriented);
}

void recordBirthContacts(World& w, const StepTools& t) {
  // the other half is at the other ends
  for (const OrientedWork::Born& b : t.oriented.born)
    w.ledger.phaseJump.add(-2 * (w.oriented.rows.energy[b.row] - b.energy));
}

double orientedStepLimit(const World& w, const StepTools& t) {
  const Oriented& o = w.oriented.rows;
  if (w.scene.oriented.empty()) return never;
  const OrientedIntegrator how = w.scene.oriented.front().integrator;  // one integrator for all, as in
                                                                       // stepOriented
  const double stable = how == OrientedIntegrator::SymplecticEuler ? 2
                        : how == OrientedIntegrator::RungeKutta    ? 2.8
                                                                   : 20;
  double dt = t.oriented.fastest2 > 0 ? perContact / std::sqrt(t.oriented.fastest2) : never;
  // obstacles are explicit in all integrators
  if (t.oriented.obstacleFrequency2 > 0)
    dt = std::min(dt, perObstacle / std::sqrt(t.oriented.obstacleFrequency2));
  for (std::size_t i = 0; i < o.owned; i++) {
    const OrientedBody& body = w.scene.oriented[o.body[i]];
    const double s = spacingOf(w.scene, body);
    if (o.stiffness[i] > 0) dt = std::min(dt, body.cfl * stable / std::sqrt(o.stiffness[i]));
    const double speed = length(o.velocity[i]), pull = length(o.force[i]) / o.mass[i];
    if (speed > 0) dt = std::min(dt, 0.1 * s / speed);
    if (pull > 0) dt = std::min(dt, std::sqrt(0.1 * s / pull));
  }
  return dt;
}

}  // namespace thaw
