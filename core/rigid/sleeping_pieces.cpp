// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/sleeping_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "core/neighbours/rows_around.hpp"
#include "core/rigid/piece_sums.hpp"

namespace thaw {
namespace {

/// Returns the distance (m) of the corners from the centre of a cube with the piece's moments of inertia.
double extentOf(const Pieces& p, std::size_t k) {
  return std::sqrt(1.5 * (p.inertia[k].x + p.inertia[k].y + p.inertia[k].z) / p.mass[k]);
}

bool onlyWeighs(const RigidView& v, std::size_t k) {
  const Pieces& p = v.pieces;
  for (int a = 0; a < 3; a++)  // same expression as in sumPieceForces, for equal bits
    if (p.force[k][a] != 0 + p.mass[k] * v.scene.domain.gravity[a]) return false;
  return p.torque[k] == Vec3d{};
}

bool anyObstacleVanishes(const RigidView& v, double dt) {
  const double from = v.clock.time - v.clock.stepDt, to = v.clock.time + dt;
  return std::ranges::any_of(
      v.walls.list, [&](const Wall& w) { return w.properties.until >= from && w.properties.until <= to; });
}

void wake(Pieces& p, std::size_t k) {
  p.sleeping[k] = 0;
  p.restTime[k] = 0;
}

/// Returns true if a piece is slow, only weight and contacts load it, and its velocity hardly changes in the
/// next step.
bool isAtRest(const RigidView& v, std::size_t k, const PieceMotion& after, double dt) {
  const Pieces& p = v.pieces;
  const Numerics& n = v.scene.numerics;
  if (!onlyWeighs(v, k)) return false;
  const double slow = n.sleepSpeed, g = length(v.scene.domain.gravity), extent = extentOf(p, k),
               // as for elastic solids: a falling piece is not at rest
      weak = std::min(slow / n.sleepAfter, g > 0 ? 0.5 * g : never);
  // Velocity during the last drift, which was before the second half kick.
  const Vec3d before = (p.momentum[k] - p.force[k] * (0.5 * v.clock.stepDt)) / p.mass[k],
              spin = spinOf(p, k, p.angularMomentum[k]);
  const double change = length(after.velocity - before) + extent * length(after.spin - spin);
  return length(after.velocity) + extent * length(after.spin) < slow && change < weak * dt;
}

/// Sums one number per row over all ranks that have the row.
void sumOfRows(const RigidView& v, std::vector<std::int64_t>& words, Reducer& all) {
  RankPieceExchange exchange = exchangeOf(v.pieces, v.work, all);
  exchange.sum(words, 1);
}

}  // namespace

void wakePieces(Pieces& p) {
  for (std::size_t k = 0; k < p.owned; k++) wake(p, k);
}

void wakeLoaded(const RigidView& v, double dt) {
  const bool every = anyObstacleVanishes(v, dt);
  for (std::size_t k = 0; k < v.pieces.owned; k++)
    if (v.pieces.sleeping[k] && (every || !onlyWeighs(v, k))) wake(v.pieces, k);
}

void wakeNearChanges(const RigidView& v, Reducer& all) {
  constexpr double near = 2;  // spacings; contacts are closer
  const Continuum& p = v.particles;
  const double reach = near * v.scene.spacing;
  std::vector<std::int64_t> changed(v.pieces.owned, 0);
  eachSurrounded(
      v.cells, p.owned, v.cells, [&](std::uint32_t i) { return p.piece[i] != p.setLabel[i]; },
      [&](std::uint32_t i, std::span<const RowSpan> ranges) {
        for (const RowSpan& r : ranges)
          for (std::uint32_t j = r.begin; j < r.end; j++) {
            const Vec3d to = p.position[j] - p.position[i];
            if (p.piece[j] != notRigid && dot(to, to) < reach * reach) changed[p.pieceRow[j]]++;
          }
      });
  sumOfRows(v, changed, all);
  for (std::size_t k = 0; k < v.pieces.owned; k++)
    if (changed[k] > 0) wake(v.pieces, k);
}

bool wakeTouched(const RigidView& v, std::span<const FoundContact> contacts, Reducer& all) {
  Pieces& p = v.pieces;
  const auto moves = [&](std::size_t k) { return !p.sleeping[k] && !p.fixed[k] && !(p.restTime[k] > 0); };
  std::vector<std::int64_t> touched(p.owned, 0);
  for (const FoundContact& f : contacts) {
    const RigidContact& c = f.contact;
    if (c.b == noPiece) {
      touched[c.a] += p.sleeping[c.a];  // sleeping pieces have contacts only with moving obstacles
      continue;
    }
    if (p.sleeping[c.a] && moves(c.b)) touched[c.a]++;
    if (p.sleeping[c.b] && moves(c.a)) touched[c.b]++;
  }
  sumOfRows(v, touched, all);
  double woke = 0;
  for (std::size_t k = 0; k < p.owned; k++)
    if (touched[k] > 0) {
      wake(p, k);
      woke = 1;
    }
  all.maximum({&woke, 1});
  return woke > 0;
}

void holdSleeping(const Pieces& p, std::span<PieceMotion> motions) {
  for (std::size_t k = 0; k < p.owned; k++) {
    if (!p.sleeping[k]) continue;
    motions[k].inverseMass = 0;
    motions[k].inverseInertia = {};
    motions[k].velocity = motions[k].spin = {};
  }
}

void updateRest(const RigidView& v, const RestInput& x, Reducer& all) {
  Pieces& p = v.pieces;
  const double enough = v.scene.numerics.sleepAfter;
  for (std::size_t k = 0; k < p.owned; k++)
    if (!p.sleeping[k] && !p.fixed[k])
      p.restTime[k] = isAtRest(v, k, x.after[k], x.dt) ? p.restTime[k] + x.dt : 0;
  std::vector<std::int64_t> movingNeighbours(p.owned, 0);
  const auto rests = [&](std::size_t k) { return p.sleeping[k] || p.fixed[k] || p.restTime[k] >= enough; };
  for (const FoundContact& f : x.contacts) {
    const RigidContact& c = f.contact;
    if (c.b == noPiece) {
      movingNeighbours[c.a] += !(c.otherVelocity == Vec3d{});
      continue;
    }
    movingNeighbours[c.a] += !rests(c.b);
    movingNeighbours[c.b] += !rests(c.a);
  }
  sumOfRows(v, movingNeighbours, all);
  for (std::size_t k = 0; k < p.owned; k++)
    if (!p.fixed[k] && p.restTime[k] >= enough && movingNeighbours[k] == 0) p.sleeping[k] = 1;
}

void balanceSleeping(Pieces& p, double dt) {
  for (std::size_t k = 0; k < p.owned; k++) {
    if (!p.sleeping[k]) continue;
    // in the order of the drift, so the sum is exactly zero
    Vec3d momentum = p.momentum[k], spin = p.angularMomentum[k];
    momentum += p.pressureImpulse[k];
    spin += p.pressureTwist[k];
    momentum += p.force[k] * (0.5 * dt);
    spin += p.torque[k] * (0.5 * dt);
    p.contactImpulse[k] = -momentum;
    p.contactTwist[k] = -spin;
    p.contactShift[k] = p.contactTurn[k] = {};
  }
}

std::int64_t countAsleep(const Pieces& p) {
  std::int64_t count = 0;
  for (std::size_t k = 0; k < p.owned; k++)
    if (p.sleeping[k]) count += p.localParticles[k];
  return count;
}

}  // namespace thaw
