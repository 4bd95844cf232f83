// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/solve_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "core/rigid/contact/accelerated_solve.hpp"

namespace thaw {
namespace {

Vec3d relativeVelocity(const RigidContact& c, std::span<const PieceMotion> pieces) {
  const Vec3d u = velocityAtArm(pieces[c.a], c.armA);
  return u - (c.b == noPiece ? c.otherVelocity : velocityAtArm(pieces[c.b], c.armB));
}

/// Least relative normal velocity of a contact after the step: it may close its gap, and rebounds if it
/// closes it fast.
double targetOf(const RigidContact& c, const ContactSettings& s, const Vec3d& u) {
  const double approach = -dot(u, c.normal), room = std::max(0.0, c.gap) / s.step;
  const bool impact = c.restitution > 0 && approach > room && approach > s.impactSpeed;
  return impact ? c.restitution * approach : -room;
}

double finiteOr(double x, double other) { return std::isfinite(x) ? x : other; }

struct VelocityProblem {
  std::vector<Vec3d> free, impulses;
  std::vector<double> target;
  double speed = 0;    ///< m/s, bound of all velocities and first guesses, over all ranks
  double deepest = 0;  ///< m, over all ranks
  double impact = 0;   ///< m/s, largest change that a target demands, over all ranks
};

VelocityProblem velocityProblem(const ContactSystem& system, const ContactSettings& settings) {
  VelocityProblem p;
  for (std::size_t i = 0; i < system.contacts.size(); i++) {
    const RigidContact& c = system.contacts[i];
    const Vec3d u = relativeVelocity(c, system.pieces);
    p.free.push_back(u);
    p.target.push_back(targetOf(c, settings, u));
    p.impulses.push_back(c.impulse);
    p.speed = std::max(p.speed, finiteOr(length(u) + system.inertia[i] * length(c.impulse), HUGE_VAL));
    p.deepest = std::max(p.deepest, finiteOr(-c.gap, HUGE_VAL));
    p.impact = std::max(p.impact, p.target.back() - dot(u, c.normal));
  }
  double most[3] = {p.speed, p.deepest, p.impact};
  system.all->maximum(most);
  p.speed = most[0];
  p.deepest = most[1];
  p.impact = most[2];
  return p;
}

enum Balance { Lost, Work, ImpulseX, ImpulseY, ImpulseZ, balances };

/// Energy that the impulses take, and what obstacles give. free: relative velocities before.
void recordBalance(const ContactSystem& system, const VelocityProblem& problem,
                   std::span<const RowChange> rows, ContactResult& result) {
  double scale = 0;
  for (std::size_t i = 0; i < problem.free.size(); i++)
    scale = std::max(scale, length(problem.impulses[i]) *
                                (1 + length(problem.free[i]) + length(system.contacts[i].otherVelocity)));
  system.all->maximum({&scale, 1});
  if (!(scale > 0)) return;
  ContactSums<balances> sums{FixedUnit::forScale(scale)};
  for (std::size_t i = 0; i < problem.free.size(); i++) {
    const RigidContact& c = system.contacts[i];
    const Vec3d mean = problem.free[i] + 0.5 * relativeChange(c, rows);
    const bool obstacle = c.b == noPiece;
    const Vec3d& j = problem.impulses[i];
    const Vec3d onPiece = obstacle ? j : Vec3d{};
    sums.add({-dot(j, mean), dot(onPiece, c.otherVelocity), onPiece.x, onPiece.y, onPiece.z});
  }
  sums.sum(*system.all);
  result.dissipated = sums.value(Lost);
  result.obstacleWork = sums.value(Work);
  result.obstacleImpulse = {sums.value(ImpulseX), sums.value(ImpulseY), sums.value(ImpulseZ)};
}

/// Sets shift and turn of the changes to displacements that remove overlap. rows: velocity changes of the
/// step, which close gaps.
int correctOverlap(ContactSystem& system, const ContactSettings& settings, const VelocityProblem& velocity,
                   std::span<const RowChange> rows, std::span<PieceChange> changes) {
  const std::size_t n = system.contacts.size();
  std::vector<Vec3d> free(n), impulses(n);
  std::vector<double> target(n);
  for (std::size_t i = 0; i < n; i++) {
    const RigidContact& c = system.contacts[i];
    const double un = dot(velocity.free[i] + relativeChange(c, rows), c.normal);
    const double gap = c.gap + un * settings.step, overlap = -gap - settings.slop;
    target[i] = overlap > 0 ? std::min(settings.correction * overlap, settings.mostCorrection) / settings.step
                            : -std::max(0.0, gap) / settings.step;
  }
  // Later steps correct the rest. Between obstacles without room for a piece, some overlap always remains.
  constexpr int mostIterations = 50;
  const double tolerance = std::max(settings.tolerance, 1e-2 * velocity.deepest / settings.step);
  std::vector<RowChange> moves;
  setSpeed(system, std::max(velocity.deepest / settings.step, settings.tolerance));
  const SolveCount count = solveAccelerated(
      system, {free, target, false, tolerance, std::min(mostIterations, settings.mostIterations)}, impulses,
      moves);
  for (std::size_t r = 0; r < changes.size(); r++) {
    changes[r].shift = settings.step * moves[r].velocity;
    changes[r].turn = settings.step * moves[r].spin;
  }
  return count.iterations;
}

}  // namespace

ContactResult solveContacts(std::span<PieceMotion> pieces, std::span<RigidContact> contacts,
                            const ContactSettings& settings, PieceExchange& exchange, Reducer& all,
                            std::span<PieceChange> changes) {
  std::fill(changes.begin(), changes.end(), PieceChange{});
  ContactSystem system = contactSystem(pieces, contacts, exchange, all);
  VelocityProblem problem = velocityProblem(system, settings);
  ContactResult result;
  result.deepest = problem.deepest;
  result.tolerance = settings.tolerance;
  if (!std::isfinite(problem.speed) || !std::isfinite(problem.deepest)) {
    result.residual = HUGE_VAL;
    result.converged = false;
    return result;
  }
  std::vector<RowChange> rows(pieces.size());
  if (problem.speed > 0) {
    setSpeed(system, problem.speed);
    result.tolerance = std::max(settings.tolerance, settings.impactPart * problem.impact);
    const SolveCount count = solveAccelerated(
        system, {problem.free, problem.target, true, result.tolerance, settings.mostIterations},
        problem.impulses, rows);
    result.iterations = count.iterations;
    result.residual = count.residual;
    result.converged = count.residual <= result.tolerance;
    clearImpulses(system);
    for (std::size_t i = 0; i < contacts.size(); i++) addImpulse(system, contacts[i], problem.impulses[i]);
    sumImpulses(system);
    for (std::size_t r = 0; r < pieces.size(); r++) {
      const RowImpulse sum = rowImpulse(system, r);
      changes[r].impulse = sum.linear;
      changes[r].angularImpulse = sum.angular;
    }
    recordBalance(system, problem, rows, result);
  }
  if (problem.deepest > settings.slop)
    result.correctionIterations = correctOverlap(system, settings, problem, rows, changes);
  for (std::size_t i = 0; i < contacts.size(); i++) contacts[i].impulse = problem.impulses[i];
  for (std::size_t r = 0; r < pieces.size(); r++) {
    pieces[r].velocity += rows[r].velocity;
    pieces[r].spin += rows[r].spin;
  }
  return result;
}

}  // namespace thaw
