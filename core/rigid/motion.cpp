// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/motion.hpp"

#include <cmath>

#include "core/domain/sides.hpp"
#include "core/rigid/piece_sums.hpp"
#include "core/rigid/rotation.hpp"

namespace thaw {
namespace {

/// Rigid motion of a piece.
struct Rigid {
  Vec3d centre, velocity, spin;
  Quat orientation;
};

Rigid rigidOf(const Pieces& p, std::size_t row) {
  return {p.centre[row], velocityOf(p, row), spinOf(p, row, p.angularMomentum[row]), p.orientation[row]};
}

/// Shifts x (m) by whole periods to the image nearest to `near` (m).
Vec3d imageNear(const CellGrid& g, Vec3d x, const Vec3d& near) {
  for (int a = 0; a < 3; a++)
    if (g.periodic[a]) x[a] -= g.period[a] * std::round((x[a] - near[a]) / g.period[a]);
  return x;
}

/// Calls use(row of the particle, motion of its piece, lever) for all owned particles of pieces.
template<class Use> void eachParticle(const RigidView& v, Use&& use) {
  Continuum& p = v.particles;
  std::vector<Rigid> motions(v.pieces.owned);
  for (std::size_t k = 0; k < motions.size(); k++) motions[k] = rigidOf(v.pieces, k);
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.piece[i] == notRigid) continue;
    const Rigid& r = motions[p.pieceRow[i]];
    use(i, r, rotated(r.orientation, p.bodyPosition[i]));
  }
}

double kineticEnergy(const Pieces& p, std::size_t k) {
  const Vec3d &P = p.momentum[k], &L = p.angularMomentum[k];
  return 0.5 * (dot(P, P) / p.mass[k] + dot(L, spinOf(p, k, L)));
}

/// Adds contact impulses in the middle of the kick over dt (s), and records them. Not all kinetic energy that
/// they remove there is dissipated. The impulses act over the step, so part of that energy replaces the
/// work of the kick.
void addContactImpulses(const RigidView& v, std::size_t k, double dt) {
  Pieces& s = v.pieces;
  const Vec3d J = s.contactImpulse[k], twist = s.contactTwist[k];
  const double before = kineticEnergy(s, k);
  s.momentum[k] += J;
  s.angularMomentum[k] += twist;
  if (!s.recordsEnergy[k]) return;
  const double kick = 0.5 * dt * (dot(s.force[k], J) / s.mass[k] + dot(spinOf(s, k, s.torque[k]), twist));
  v.ledger.dissipated.add(before - kineticEnergy(s, k) + kick);
  v.ledger.dissipated.add(s.mass[k] * dot(v.scene.domain.gravity, s.contactShift[k]));
  for (int a = 0; a < 3; a++) v.ledger.wallImpulse[a].add(J[a]);
}

void drift(const RigidView& v, std::size_t k, double dt) {
  Pieces& s = v.pieces;
  if (!s.fixed[k]) {
    addImpulse(v, k, s.pressureImpulse[k], s.pressureTwist[k]);
    s.momentum[k] += s.force[k] * (0.5 * dt);
    s.angularMomentum[k] += s.torque[k] * (0.5 * dt);
    addContactImpulses(v, k, dt);
    s.centre[k] += velocityOf(s, k) * dt + s.contactShift[k];
    s.orientation[k] = rotateFreely(s.orientation[k], s.angularMomentum[k], s.inertia[k], dt);
    if (!(s.contactTurn[k] == Vec3d{}))
      s.orientation[k] = unitQuat(rotationBy(s.contactTurn[k]) * s.orientation[k]);
    wrapPlace(v.grid, v.scene.domain, s.centre[k]);
  }
  s.pressureImpulse[k] = s.pressureTwist[k] = {};
  s.contactImpulse[k] = s.contactTwist[k] = s.contactShift[k] = s.contactTurn[k] = {};
}

}  // namespace

void addImpulse(const RigidView& v, std::size_t k, const Vec3d& impulse, const Vec3d& twist) {
  Pieces& s = v.pieces;
  if (s.fixed[k] || (impulse == Vec3d{} && twist == Vec3d{})) return;
  const double before = kineticEnergy(s, k);
  s.momentum[k] += impulse;
  s.angularMomentum[k] += twist;
  if (s.recordsEnergy[k]) v.ledger.dissipated.add(before - kineticEnergy(s, k));
}

Vec3d angularAcceleration(const Pieces& p, std::size_t k) {
  if (p.fixed[k]) return {};
  return spinOf(p, k, p.torque[k] - cross(spinOf(p, k, p.angularMomentum[k]), p.angularMomentum[k]));
}

void driftPieces(const RigidView& v, double dt) {
  for (std::size_t k = 0; k < v.pieces.owned; k++) drift(v, k, dt);
  Continuum& p = v.particles;
  eachParticle(v, [&](std::size_t i, const Rigid& r, const Vec3d& lever) {
    if (v.pieces.fixed[p.pieceRow[i]]) return;
    p.position[i] = imageNear(v.grid, r.centre + lever, p.position[i]);
    p.velocity[i] = r.velocity + cross(r.spin, lever);
  });
}

void sumPieceForces(const RigidView& v, Reducer& all) {
  constexpr std::size_t perPiece = 6;
  Pieces& s = v.pieces;
  Continuum& p = v.particles;
  const Vec3d g = v.scene.domain.gravity;
  v.work.sums.assign(perPiece * s.owned, ExactSum{});
  eachParticle(v, [&](std::size_t i, const Rigid&, const Vec3d& lever) {
    const Vec3d f = p.force[i], torque = cross(lever, f);
    if (f == Vec3d{}) return;
    ExactSum* const sums = v.work.sums.data() + perPiece * p.pieceRow[i];
    for (int a = 0; a < 3; a++) {
      sums[a].add(f[a]);
      sums[3 + a].add(torque[a]);
    }
  });
  RankPieceExchange exchange = exchangeOf(s, v.work, all);
  sumOverRanks(exchange, v.work.sums, perPiece, v.work.words);
  std::vector<Vec3d> turning(s.owned);
  for (std::size_t k = 0; k < s.owned; k++) {
    const ExactSum* const sums = v.work.sums.data() + perPiece * k;
    for (int a = 0; a < 3; a++) {
      s.force[k][a] = sums[a].value() + s.mass[k] * g[a];
      s.torque[k][a] = sums[3 + a].value();
    }
    turning[k] = angularAcceleration(s, k);
  }
  eachParticle(v, [&](std::size_t i, const Rigid& r, const Vec3d& lever) {
    const std::uint32_t k = p.pieceRow[i];
    const Vec3d a = s.fixed[k] ? Vec3d{}
                               : s.force[k] / s.mass[k] + cross(turning[k], lever) +
                                     cross(r.spin, cross(r.spin, lever));
    p.force[i] = (a - g) * p.mass[i];
  });
}

void kickPieces(const RigidView& v, double dt) {
  Pieces& s = v.pieces;
  for (std::size_t k = 0; k < s.owned; k++) {
    if (s.fixed[k]) continue;
    s.momentum[k] += s.force[k] * (0.5 * dt);
    s.angularMomentum[k] += s.torque[k] * (0.5 * dt);
  }
  Continuum& p = v.particles;
  eachParticle(v, [&](std::size_t i, const Rigid& r, const Vec3d& lever) {
    p.velocity[i] = r.velocity + cross(r.spin, lever);
  });
}

}  // namespace thaw
