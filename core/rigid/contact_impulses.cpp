// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact_impulses.hpp"

#include <algorithm>
#include <cmath>

#include "core/rigid/contact/find_contacts.hpp"
#include "core/rigid/contact/solve_contacts.hpp"
#include "core/rigid/piece_sums.hpp"

namespace thaw {
namespace {

/// Inverse inertia tensor along the axes of the domain.
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

/// Motions of all pieces after the first half kick of the next step.
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
  // Errors add up over the height of a stack and let it creep.
  s.tolerance = std::max(1e-6 * spacing / dt, 3e-3 * length(v.scene.domain.gravity) * dt);
  return s;
}

}  // namespace

void findContactImpulses(const RigidView& v, const Halos& halos, double dt) {
  Pieces& p = v.pieces;
  std::vector<PieceMotion> motions = nextMotions(p, dt);
  std::vector<FoundContact> found = findContacts({v.scene, v.grid, v.particles, v.cells, p, v.walls, dt},
                                                 motions, halos.all);
  std::vector<RigidContact> contacts;
  for (const FoundContact& f : found) contacts.push_back(f.contact);
  std::vector<PieceChange> changes(motions.size());
  RankPieceExchange exchange = exchangeOf(p, v.work, halos.all);
  const ContactResult result = solveContacts(motions, contacts, settingsOf(v, dt), exchange, halos.all,
                                             changes);
  for (std::size_t k = 0; k < found.size(); k++) found[k].contact.impulse = contacts[k].impulse;
  keepImpulses(found, v.particles);
  for (std::size_t k = 0; k < p.owned; k++) {
    p.contactImpulse[k] = changes[k].impulse;
    p.contactTwist[k] = changes[k].angularImpulse;
    p.contactShift[k] = changes[k].shift;
    p.contactTurn[k] = changes[k].turn;
  }
  if (halos.all.rank() != 0) return;
  // The work on pieces raises their kinetic energy, which the drift subtracts from the dissipated one.
  v.ledger.wallWork.add(result.obstacleWork);
  v.ledger.dissipated.add(result.obstacleWork);
}

}  // namespace thaw
