// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/solve_island.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/rigid/contact/impact_sequence.hpp"
#include "core/rigid/contact/rolling.hpp"

namespace thaw {
namespace {

/// Change of a row's motion due to impulses.
struct Row {
  Vec3d velocity{}, spin{};
};

/// Contact in the basis of its normal and two tangents.
struct Contact {
  std::uint32_t a = 0, b = noPiece;
  Vec3d axis[3];               ///< normal and tangents
  Vec3d armA{}, armB{};        ///< m
  double offset[3] = {};       ///< m/s, free velocity minus target
  double impulse[3] = {};      ///< N s
  double response[3][3] = {};  ///< 1/kg, response of the contact's velocity to its own impulse
  double inverse[3] = {};      ///< kg, components 11, 12 and 22 of the inverse tangential response
  double stiffest = 0;         ///< 1/kg, largest eigenvalue of the tangential response
  double friction = 0;
  double before[3] = {};  ///< N s, impulse at the start of the sweep
  double other[3] = {};   ///< N s, search direction, or impulse after the last sweep
};

struct Problem {
  std::span<const PieceMotion> pieces;
  std::vector<Contact> contacts;
  std::vector<Rolling> rolling;    ///< contacts with rolling friction
  std::vector<Row> rows;           ///< changes due to the impulses
  std::vector<Row> before, other;  ///< the same due to Contact::before and Contact::other
};

/// Adds an impulse (N s) on a row at a point.
void push(const PieceMotion& piece, const Vec3d& arm, const Vec3d& impulse, Row& row) {
  row.velocity += piece.inverseMass * impulse;
  row.spin += piece.inverseInertia * cross(arm, impulse);
}

void push(Problem& p, const Contact& c, const Vec3d& impulse) {
  push(p.pieces[c.a], c.armA, impulse, p.rows[c.a]);
  if (c.b != noPiece) push(p.pieces[c.b], c.armB, -impulse, p.rows[c.b]);
}

void turn(Problem& p, const Rolling& r, const Vec3d& impulse) {
  const Contact& c = p.contacts[r.contact];
  p.rows[c.a].spin += p.pieces[c.a].inverseInertia * impulse;
  if (c.b != noPiece) p.rows[c.b].spin -= p.pieces[c.b].inverseInertia * impulse;
}

Vec3d vectorOf(const Contact& c, const double (&x)[3]) {
  return x[0] * c.axis[0] + x[1] * c.axis[1] + x[2] * c.axis[2];
}

/// Returns the change of the relative velocity due to the changes of the rows.
Vec3d changeOf(const Problem& p, const Contact& c) {
  Vec3d u = p.rows[c.a].velocity + cross(p.rows[c.a].spin, c.armA);
  if (c.b != noPiece) u -= p.rows[c.b].velocity + cross(p.rows[c.b].spin, c.armB);
  return u;
}

/// Returns the change of the relative spin due to the changes of the rows.
Vec3d changeOf(const Problem& p, const Rolling& r) {
  const Contact& c = p.contacts[r.contact];
  return c.b == noPiece ? p.rows[c.a].spin : p.rows[c.a].spin - p.rows[c.b].spin;
}

void setAxes(Contact& c, const Vec3d& normal) {
  c.axis[0] = normal;
  c.axis[1] = normalized(cross(normal, leastAxis(normal)));
  c.axis[2] = cross(normal, c.axis[1]);
}

void setResponse(std::span<const PieceMotion> pieces, Contact& c) {
  for (int k = 0; k < 3; k++) {
    Row a, b;
    push(pieces[c.a], c.armA, c.axis[k], a);
    if (c.b != noPiece) push(pieces[c.b], c.armB, c.axis[k], b);
    const Vec3d u = a.velocity + cross(a.spin, c.armA) + b.velocity + cross(b.spin, c.armB);
    for (int l = 0; l < 3; l++) c.response[l][k] = dot(u, c.axis[l]);
  }
  const double t11 = c.response[1][1], t12 = c.response[1][2], t22 = c.response[2][2];
  const double determinant = t11 * t22 - t12 * t12, half = 0.5 * (t11 - t22);
  c.stiffest = 0.5 * (t11 + t22) + std::sqrt(half * half + t12 * t12);
  if (!(determinant > 0)) return;
  c.inverse[0] = t22 / determinant;
  c.inverse[1] = -t12 / determinant;
  c.inverse[2] = t11 / determinant;
}

/// Returns true if a tangential impulse is outside of the disc of Coulomb friction.
bool slides(const Contact& c, const double (&t)[2]) {
  const double most = c.friction * c.impulse[0];
  return t[0] * t[0] + t[1] * t[1] > most * most;
}

/// Projects the tangential impulse onto the disc of Coulomb friction.
void cutTangential(const Contact& c, double (&t)[2]) {
  if (!slides(c, t)) return;
  const double most = c.friction * c.impulse[0];
  const double factor = most > 0 ? most / std::sqrt(t[0] * t[0] + t[1] * t[1]) : 0;
  t[0] *= factor;
  t[1] *= factor;
}

/// Solves a contact for the current velocities of its rows. Returns its velocity error (m/s).
double relax(Problem& p, Contact& c) {
  const Vec3d change = changeOf(p, c);
  double u[3], step[3];
  for (int k = 0; k < 3; k++) u[k] = c.offset[k] + dot(change, c.axis[k]);
  const double normal = std::max(0.0, c.impulse[0] - u[0] / c.response[0][0]);
  step[0] = normal - c.impulse[0];
  c.impulse[0] = normal;
  u[1] += c.response[1][0] * step[0];
  u[2] += c.response[2][0] * step[0];
  double t[2] = {c.impulse[1] - (c.inverse[0] * u[1] + c.inverse[1] * u[2]),
                 c.impulse[2] - (c.inverse[1] * u[1] + c.inverse[2] * u[2])};
  if (slides(c, t)) {
    t[0] = c.impulse[1] - u[1] / c.stiffest;
    t[1] = c.impulse[2] - u[2] / c.stiffest;
    cutTangential(c, t);
  }
  for (int k = 0; k < 2; k++) {
    step[k + 1] = t[k] - c.impulse[k + 1];
    c.impulse[k + 1] = t[k];
  }
  push(p, c, vectorOf(c, step));
  return std::max(std::abs(step[0]) * c.response[0][0],
                  std::sqrt(step[1] * step[1] + step[2] * step[2]) * c.stiffest);
}

/// Sets the velocities of rows from the impulses of all contacts.
void sumImpulses(Problem& p) {
  std::fill(p.rows.begin(), p.rows.end(), Row{});
  for (const Contact& c : p.contacts) push(p, c, vectorOf(c, c.impulse));
  for (const Rolling& r : p.rolling) turn(p, r, r.impulse);
}

/// Solves the rolling friction of a contact. Returns its velocity error (m/s).
double relax(Problem& p, Rolling& r) {
  const Vec3d step = relaxRolling(r, changeOf(p, r), p.contacts[r.contact].impulse[0]);
  turn(p, r, step);
  return length(step) * r.stiffest * r.radius;
}

/// Solves each contact once. Returns the largest velocity error (m/s), or NaN if any error is NaN.
double sweep(Problem& p) {
  double largest = 0;
  const auto add = [&](double error) {
    if (!(error <= largest)) largest = error;
  };
  for (Contact& c : p.contacts)
    if (c.response[0][0] > 0) add(relax(p, c));
  for (Rolling& r : p.rolling) add(relax(p, r));
  return largest;
}

/// Stores the state before a sweep.
void keepState(Problem& p) {
  p.before = p.rows;
  for (Contact& c : p.contacts) std::copy_n(c.impulse, 3, c.before);
  for (Rolling& r : p.rolling) r.before = r.impulse;
}

/// Returns the weight (1/kg) of direction k of a contact in the metric of the contacts.
double weightOf(const Contact& c, int k) { return k == 0 ? c.response[0][0] : c.stiffest; }

/// Returns the squared norm of the last sweep's change, in the metric of the contacts.
double squareOfChange(const Problem& p) {
  double sum = 0;
  for (const Contact& c : p.contacts)
    for (int k = 0; k < 3; k++) {
      const double d = c.impulse[k] - c.before[k];
      sum += weightOf(c, k) * d * d;
    }
  for (const Rolling& r : p.rolling) {
    const Vec3d d = r.impulse - r.before;
    sum += r.stiffest * dot(d, d);
  }
  return sum;
}

/// Calls use(value, value before the sweep, other value) for all impulses and velocities.
template<class Use> void eachNumber(Problem& p, Use&& use) {
  for (Contact& c : p.contacts)
    for (int k = 0; k < 3; k++) use(c.impulse[k], c.before[k], c.other[k]);
  for (Rolling& r : p.rolling)
    for (int k = 0; k < 3; k++) use(r.impulse[k], r.before[k], r.other[k]);
  for (std::size_t r = 0; r < p.rows.size(); r++)
    for (int a = 0; a < 3; a++) {
      use(p.rows[r].velocity[a], p.before[r].velocity[a], p.other[r].velocity[a]);
      use(p.rows[r].spin[a], p.before[r].spin[a], p.other[r].spin[a]);
    }
}

/// Moves impulses along the search direction. The direction becomes beta times itself plus the sweep's
/// change.
void moveAlong(Problem& p, double beta) {
  eachNumber(p, [&](double& x, double before, double& direction) {
    const double change = x - before;
    x += beta * direction;
    direction = beta * direction + change;
  });
}

/// Moves impulses by beta times their change since the last sweep.
void extrapolate(Problem& p, double beta) {
  eachNumber(p, [&](double& x, double, double& last) {
    const double now = x;
    x += beta * (x - last);
    last = now;
  });
}

/// Returns true if the sweep's change opposes the step since the last sweep.
bool opposes(const Problem& p) {
  double sum = 0;
  for (const Contact& c : p.contacts)
    for (int k = 0; k < 3; k++)
      sum += weightOf(c, k) * (c.impulse[k] - c.before[k]) * (c.impulse[k] - c.other[k]);
  for (const Rolling& r : p.rolling) sum += r.stiffest * dot(r.impulse - r.before, r.impulse - r.other);
  return sum < 0;
}

struct Progress {
  int iterations = 0;
  double error = 0;  ///< m/s, largest error in the last sweep
};

/// Iterates with conjugate gradients until no error exceeds the tolerance (m/s). The sweep's change is the
/// negative gradient. The direction restarts when the gradient grows [SNE10]. The last operation is a sweep,
/// so impulses are within their friction cones.
Progress conjugateGradients(Problem& p, double tolerance, int most) {
  Progress at;
  p.other.assign(p.rows.size(), {});
  for (Contact& c : p.contacts) std::fill_n(c.other, 3, 0.0);
  for (Rolling& r : p.rolling) r.other = {};
  double last = 0;
  while (at.iterations < most) {
    keepState(p);
    at = {at.iterations + 1, sweep(p)};
    if (at.error <= tolerance || at.iterations == most) break;
    const double square = squareOfChange(p);
    moveAlong(p, last > 0 && square <= last ? square / last : 0);
    last = square;
  }
  return at;
}

/// Iterates with Nesterov's momentum [N83] until no error exceeds the tolerance (m/s). The momentum restarts
/// when the sweep's change opposes the step [OC15]. The last operation is a sweep, as above.
Progress momentum(Problem& p, double tolerance, int most) {
  Progress at;
  p.other = p.rows;
  for (Contact& c : p.contacts) std::copy_n(c.impulse, 3, c.other);
  for (Rolling& r : p.rolling) r.other = r.impulse;
  double t = 1;
  while (at.iterations < most) {
    keepState(p);
    at = {at.iterations + 1, sweep(p)};
    if (at.error <= tolerance || at.iterations == most) break;
    const double last = opposes(p) ? 1 : t, next = 0.5 * (1 + std::sqrt(1 + 4 * last * last));
    extrapolate(p, (last - 1) / next);
    t = last < t ? 1 : next;
  }
  return at;
}

/// Iterates until no velocity error exceeds the tolerance. Conjugate gradients converge faster, but stall if
/// friction makes errors grow slowly. Momentum does not stall, but may diverge, so the two methods alternate.
Progress iterate(Problem& p, double tolerance, int most) {
  constexpr int turn[2] = {30, 120};  // iterations
  Progress at{0, HUGE_VAL};
  sumImpulses(p);
  for (int k = 0; at.iterations < most && !(at.error <= tolerance); k++) {
    const int end = std::min(turn[k % 2], most - at.iterations);
    const Progress part = k % 2 ? momentum(p, tolerance, end) : conjugateGradients(p, tolerance, end);
    at = {at.iterations + part.iterations, part.error};
  }
  return at;
}

void setImpulse(Contact& c, const Vec3d& impulse) {
  for (int k = 0; k < 3; k++) c.impulse[k] = dot(impulse, c.axis[k]);
  c.impulse[0] = std::max(0.0, c.impulse[0]);
  double t[2] = {c.impulse[1], c.impulse[2]};
  cutTangential(c, t);
  c.impulse[1] = t[0];
  c.impulse[2] = t[1];
}

Problem problemOf(const ContactIsland& island, const ImpactTargets& targets) {
  Problem p{island.pieces, {}, {}, std::vector<Row>(island.pieces.size()), {}, {}};
  p.contacts.resize(island.contacts.size());
  for (std::size_t i = 0; i < p.contacts.size(); i++) {
    const RigidContact& from = island.contacts[i];
    Contact& c = p.contacts[i];
    c.a = from.a;
    c.b = from.b;
    c.armA = from.armA;
    c.armB = from.armB;
    c.friction = from.friction;
    setAxes(c, from.normal);
    setResponse(p.pieces, c);
    const double hit = targets.impulse.empty() ? 0 : targets.impulse[i];
    if (c.response[0][0] > 0) setImpulse(c, from.impulse + hit * from.normal);
    if (!(from.rolling > 0)) continue;
    Rolling r = rollingOf(from, p.pieces[c.a], c.b == noPiece ? nullptr : &p.pieces[c.b]);
    r.contact = static_cast<std::uint32_t>(i);
    if (r.stiffest > 0) p.rolling.push_back(r);
  }
  return p;
}

/// Velocities and targets of the contacts of an island.
struct Demands {
  std::vector<Vec3d> free;  ///< m/s, relative velocities without impulses
  double impact = 0;        ///< m/s, largest velocity change that a target requires
};

Demands demandVelocities(const ContactIsland& island, const std::vector<double>& targets, Problem& p) {
  Demands d;
  for (std::size_t i = 0; i < p.contacts.size(); i++) {
    const RigidContact& c = island.contacts[i];
    const Vec3d u = relativeVelocity(c, island.pieces);
    const double target = targets[i];
    d.free.push_back(u);
    d.impact = std::max(d.impact, target - dot(u, c.normal));
    for (int k = 0; k < 3; k++) p.contacts[i].offset[k] = dot(u, p.contacts[i].axis[k]);
    p.contacts[i].offset[0] -= target;
  }
  return d;
}

/// Finds displacements that remove overlap, and sets them as changes of the rows. Returns the number of
/// iterations.
int correctOverlap(ContactIsland& island, const ContactSettings& settings, const Demands& demands,
                   Problem& p) {
  double deepest = 0;
  std::vector<double> error(p.contacts.size());
  for (std::size_t i = 0; i < p.contacts.size(); i++) {
    const RigidContact& c = island.contacts[i];
    const double un = dot(demands.free[i] + changeOf(p, p.contacts[i]), c.normal);
    const double gap = c.gap + un * settings.step, overlap = -gap - settings.slop;
    deepest = std::max(deepest, -c.gap);
    error[i] = overlap > 0 ? -std::min(settings.correction * overlap, settings.mostCorrection) / settings.step
                           : std::max(0.0, gap) / settings.step;
  }
  if (!(deepest > settings.slop)) return 0;
  p.rolling.clear();
  for (std::size_t i = 0; i < p.contacts.size(); i++) {
    Contact& c = p.contacts[i];
    c.friction = 0;
    std::fill_n(c.offset, 3, 0.0);
    std::fill_n(c.impulse, 3, 0.0);
    c.offset[0] = error[i];
  }
  // Later steps correct the rest. If a piece does not fit between obstacles, some overlap always remains.
  constexpr int mostIterations = 50;
  const double tolerance = std::max(settings.tolerance, 1e-2 * deepest / settings.step);
  const int iterations = iterate(p, tolerance, std::min(mostIterations, settings.mostIterations)).iterations;
  sumImpulses(p);
  for (std::size_t r = 0; r < island.changes.size(); r++) {
    island.changes[r].shift = settings.step * p.rows[r].velocity;
    island.changes[r].turn = settings.step * p.rows[r].spin;
  }
  return iterations;
}

/// Stores the results of rolling friction.
void takeRolling(const Problem& p, ContactIsland& island, IslandSolve& s) {
  for (RigidContact& c : island.contacts) c.angularImpulse = {};
  s.meanSpin.resize(p.rolling.empty() ? 0 : p.contacts.size());
  for (const Rolling& r : p.rolling) {
    RigidContact& c = island.contacts[r.contact];
    c.angularImpulse = r.impulse;
    s.meanSpin[r.contact] = r.offset + 0.5 * changeOf(p, r);
    island.changes[c.a].angularImpulse += r.impulse;
    if (c.b != noPiece) island.changes[c.b].angularImpulse -= r.impulse;
  }
}

/// Impulses for given targets.
struct Velocities {
  Problem problem;
  Demands demands;
  IslandSolve solve;
};

Velocities solveVelocities(const ContactIsland& island, const ContactSettings& settings,
                           const ImpactTargets& targets) {
  Velocities v{problemOf(island, targets), {}, {}};
  v.demands = demandVelocities(island, targets.speed, v.problem);
  v.solve.tolerance = std::max(settings.tolerance, settings.impactPart * v.demands.impact);
  const Progress progress = iterate(v.problem, v.solve.tolerance, settings.mostIterations);
  v.solve.iterations = progress.iterations;
  v.solve.residual = std::isfinite(progress.error) ? progress.error : HUGE_VAL;
  sumImpulses(v.problem);
  return v;
}

/// Returns true if the impulses gain energy, beyond a small part of what the tolerance allows.
bool gainsEnergy(const Velocities& v) {
  constexpr double allowed = 1e-3;
  double gain = 0, error = 0;
  for (std::size_t i = 0; i < v.problem.contacts.size(); i++) {
    const Contact& c = v.problem.contacts[i];
    const Vec3d j = vectorOf(c, c.impulse);
    gain += dot(j, v.demands.free[i] + 0.5 * changeOf(v.problem, c));
    error += length(j) * v.solve.tolerance;
  }
  for (const Rolling& r : v.problem.rolling) gain += dot(r.impulse, r.offset + 0.5 * changeOf(v.problem, r));
  return gain > allowed * error;
}

/// Returns the solution with successive impacts, or with simultaneous impacts if the former gains energy. A
/// gain is possible with friction, since the impact sequence has no friction.
Velocities solveVelocities(const ContactIsland& island, const ContactSettings& settings) {
  const ImpactTargets targets = successiveImpacts(island, settings);
  Velocities v = solveVelocities(island, settings, targets);
  if (targets.impulse.empty() || !gainsEnergy(v)) return v;
  return solveVelocities(island, settings, simultaneousImpacts(island, settings));
}

}  // namespace

IslandSolve solveIsland(ContactIsland& island, const ContactSettings& settings) {
  Velocities v = solveVelocities(island, settings);
  Problem& p = v.problem;
  IslandSolve s = std::move(v.solve);
  for (std::size_t i = 0; i < p.contacts.size(); i++) {
    const Contact& c = p.contacts[i];
    const Vec3d j = vectorOf(c, c.impulse);
    island.contacts[i].impulse = j;
    s.mean.push_back(v.demands.free[i] + 0.5 * changeOf(p, c));
    island.changes[c.a].impulse += j;
    island.changes[c.a].angularImpulse += cross(c.armA, j);
    if (c.b == noPiece) continue;
    island.changes[c.b].impulse -= j;
    island.changes[c.b].angularImpulse -= cross(c.armB, j);
  }
  takeRolling(p, island, s);
  const std::vector<Row> rows = p.rows;
  s.correctionIterations = correctOverlap(island, settings, v.demands, p);
  for (std::size_t r = 0; r < rows.size(); r++) {
    island.pieces[r].velocity += rows[r].velocity;
    island.pieces[r].spin += rows[r].spin;
  }
  return s;
}

}  // namespace thaw
