// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/impact_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thaw {
namespace {

constexpr int mostRounds = 200;
constexpr int mostSweeps = 200;          // maximum number of sweeps in a round
constexpr double roundTolerance = 1e-4;  // tolerance over the largest approach speed of the round

/// Motions of an island during its impacts, and responses of its contacts.
struct Impacts {
  const ContactIsland& island;
  std::vector<PieceMotion> now;
  std::vector<double> response;  ///< 1/kg, response of each contact's normal velocity to its impulse
};

/// Contact that rebounds in a round.
struct Rebound {
  std::size_t contact;
  double target;       ///< m/s
  double impulse = 0;  ///< N s
};

void push(PieceMotion& piece, const Vec3d& arm, const Vec3d& impulse) {
  piece.velocity += piece.inverseMass * impulse;
  piece.spin += piece.inverseInertia * cross(arm, impulse);
}

void push(Impacts& m, const RigidContact& c, double impulse) {
  push(m.now[c.a], c.armA, impulse * c.normal);
  if (c.b != noPiece) push(m.now[c.b], c.armB, -impulse * c.normal);
}

double normalSpeed(const Impacts& m, const RigidContact& c) {
  return dot(relativeVelocity(c, m.now), c.normal);
}

Impacts impactsOf(const ContactIsland& island) {
  Impacts m{island, island.pieces, {}};
  const auto add = [&](const PieceMotion& p, const Vec3d& arm, const Vec3d& n) {
    return p.inverseMass + dot(cross(p.inverseInertia * cross(arm, n), arm), n);
  };
  for (const RigidContact& c : island.contacts) {
    double w = add(island.pieces[c.a], c.armA, c.normal);
    if (c.b != noPiece) w += add(island.pieces[c.b], c.armB, c.normal);
    m.response.push_back(w);
  }
  return m;
}

double roomOf(const RigidContact& c, const ContactSettings& s) { return std::max(0.0, c.gap) / s.step; }

/// Returns true if a contact closes in the step, fast enough for an impact. speed: m/s, normal velocity. The
/// contact must also close without the velocity that gravity adds, since gravity alone closes gaps on the
/// outline of a rolling body. Speeds below the tolerance do not count, so impacts also end without gravity.
bool hits(const RigidContact& c, const ContactSettings& s, double speed) {
  const double byGravity = 0.55 * s.impactSpeed;  // a tenth more than gravity adds
  return -speed > roomOf(c, s) + std::max(byGravity, s.tolerance) &&
         -speed > std::max(s.impactSpeed, s.tolerance);
}

double targetOf(const RigidContact& c, const ContactSettings& s, double speed) {
  return c.restitution > 0 && hits(c, s, speed) ? -c.restitution * speed : -roomOf(c, s);
}

/// Lists the contacts with impacts. Returns their largest approach speed (m/s).
double findHits(const Impacts& m, const ContactSettings& s, std::vector<Rebound>& round) {
  double fastest = 0;
  round.clear();
  for (std::size_t i = 0; i < m.response.size(); i++) {
    const RigidContact& c = m.island.contacts[i];
    const double speed = normalSpeed(m, c);
    if (!(m.response[i] > 0) || !hits(c, s, speed)) continue;
    round.push_back({i, targetOf(c, s, speed)});
    fastest = std::max(fastest, -speed);
  }
  return fastest;
}

/// Brings the contacts of a round to their target velocities, by projected Gauss-Seidel sweeps.
void rebound(Impacts& m, std::vector<Rebound>& round, double tolerance) {
  for (int k = 0; k < mostSweeps; k++) {
    double error = 0;
    for (Rebound& r : round) {
      const RigidContact& c = m.island.contacts[r.contact];
      const double off = normalSpeed(m, c) - r.target, w = m.response[r.contact];
      const double next = std::max(0.0, r.impulse - off / w), change = next - r.impulse;
      r.impulse = next;
      push(m, c, change);
      error = std::max(error, std::abs(change) * w);
    }
    if (error <= tolerance) return;
  }
}

}  // namespace

ImpactTargets simultaneousImpacts(const ContactIsland& island, const ContactSettings& settings) {
  ImpactTargets t;
  for (const RigidContact& c : island.contacts)
    t.speed.push_back(targetOf(c, settings, dot(relativeVelocity(c, island.pieces), c.normal)));
  return t;
}

ImpactTargets successiveImpacts(const ContactIsland& island, const ContactSettings& settings) {
  ImpactTargets t = simultaneousImpacts(island, settings);
  if (std::none_of(t.speed.begin(), t.speed.end(), [](double v) { return v > 0; })) return t;
  Impacts m = impactsOf(island);
  std::vector<Rebound> round;
  std::vector<double> impulse(t.speed.size(), 0);
  double fastest = findHits(m, settings, round);
  int rounds = 0;
  for (; rounds < mostRounds && !round.empty(); rounds++) {
    rebound(m, round, std::max(0.01 * settings.tolerance, roundTolerance * fastest));
    for (const Rebound& r : round) impulse[r.contact] += r.impulse;
    fastest = findHits(m, settings, round);
  }
  if (!round.empty() || rounds < 2) return t;
  for (std::size_t i = 0; i < t.speed.size(); i++) {
    const RigidContact& c = island.contacts[i];
    t.speed[i] = -roomOf(c, settings);
    if (impulse[i] > 0) t.speed[i] = std::max(t.speed[i], normalSpeed(m, c));
  }
  t.impulse = std::move(impulse);
  return t;
}

}  // namespace thaw
