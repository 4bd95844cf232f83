// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact_impulses.hpp"

#include <algorithm>
#include <cmath>

#include "core/rigid/piece_sums.hpp"
#include "core/rigid/sleeping_pieces.hpp"

namespace thaw {
namespace {

/// Returns the inverse inertia tensor (1/(kg m^2)) along the axes of the domain.
Sym3d inverseInertia(const Pieces& p, std::size_t k) {
  Sym3d sum{};
  for (int a = 0; a < 3; a++) {
    Vec3d axis{};
    axis[a] = 1;
    const Vec3d n = rotated(p.orientation[k], axis);
    sum = sum +
          (1 / p.inertia[k][a]) * Sym3d{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z};
  }
  return sum;
}

/// Returns the motions of all pieces after the first half kick of the next step, of dt (s).
std::vector<PieceMotion> nextMotions(const Pieces& p, double dt) {
  std::vector<PieceMotion> motions(p.owned);
  for (std::size_t k = 0; k < p.owned; k++) {
    PieceMotion& m = motions[k];
    m.centre = p.centre[k];
    if (p.fixed[k]) continue;
    m.inverseMass = 1 / p.mass[k];
    m.inverseInertia = inverseInertia(p, k);
    m.velocity = (p.momentum[k] + p.pressureImpulse[k] + p.force[k] * (0.5 * dt)) / p.mass[k];
    m.spin = spinOf(p, k, p.angularMomentum[k] + p.pressureTwist[k] + p.torque[k] * (0.5 * dt));
  }
  return motions;
}

ContactSettings settingsOf(const RigidView& v, double dt) {
  ContactSettings s;
  const double spacing = v.scene.spacing;
  s.step = dt;
  s.impactSpeed = 2 * length(v.scene.domain.gravity) * dt;
  s.slop = 0.01 * spacing;
  s.mostCorrection = 0.05 * spacing;
  // Errors accumulate over the height of a stack, and the stack would creep.
  s.tolerance = std::max(1e-6 * spacing / dt, 3e-3 * length(v.scene.domain.gravity) * dt);
  // While pieces collide, these errors change positions by much less than the slop.
  s.impactPart = 2e-3;
  return s;
}

/// Finds the contacts of awake pieces, including those that the contacts wake.
std::vector<FoundContact> contactsOfAwake(const RigidView& v, const Halos& halos, double dt,
                                          std::vector<PieceMotion>& motions) {
  const ContactSearch search{v.scene, v.grid, v.particles, v.cells, v.pieces, v.walls, dt};
  if (!v.modules.pieceSleep) return findContacts(search, motions, halos.all);
  wakeLoaded(v, dt);
  for (;;) {
    motions = nextMotions(v.pieces, dt);
    holdSleeping(v.pieces, motions);
    std::vector<FoundContact> found = findContacts(search, motions, halos.all);
    if (!wakeTouched(v, found, halos.all)) return found;
  }
}

}  // namespace

SolvedContacts findContactImpulses(const RigidView& v, const Halos& halos, double dt) {
  Pieces& p = v.pieces;
  SolvedContacts solved;
  std::vector<PieceMotion>& motions = solved.after;
  motions = nextMotions(p, dt);
  solved.contacts = contactsOfAwake(v, halos, dt, motions);
  std::vector<RigidContact> contacts;
  for (const FoundContact& f : solved.contacts) contacts.push_back(f.contact);
  std::vector<PieceChange> changes(motions.size());
  RankPieceExchange exchange = exchangeOf(p, v.work, halos.all);
  solved.result = solveContacts(motions, contacts, settingsOf(v, dt), exchange, halos.all, changes);
  solved.tolerance = solved.result.tolerance;
  for (std::size_t k = 0; k < contacts.size(); k++) solved.contacts[k].contact = contacts[k];
  keepImpulses(solved.contacts, p, v.particles);
  for (std::size_t k = 0; k < p.owned; k++) {
    p.contactImpulse[k] = changes[k].impulse;
    p.contactTwist[k] = changes[k].angularImpulse;
    p.contactShift[k] = changes[k].shift;
    p.contactTurn[k] = changes[k].turn;
  }
  return solved;
}

void acceptContacts(const RigidView& v, const SolvedContacts& solved, double dt, Reducer& all) {
  const ContactResult& result = solved.result;
  v.work.contacts = {result.iterations + result.correctionIterations, result.residual, solved.tolerance,
                     std::max(v.work.contacts.deepest, result.deepest)};
  if (v.modules.pieceSleep) {
    updateRest(v, {solved.contacts, solved.after, dt}, all);
    balanceSleeping(v.pieces, dt);
    v.counters.sleeping = countAsleep(v.pieces);
  }
  if (all.rank() != 0) return;
  v.counters.contactIterations += v.work.contacts.iterations;
  v.counters.contactUnfinished += !result.converged;
  // This work increases the kinetic energy of pieces. The drift subtracts that increase from the dissipated
  // energy.
  v.ledger.wallWork.add(result.obstacleWork);
  v.ledger.dissipated.add(result.obstacleWork);
}

}  // namespace thaw
