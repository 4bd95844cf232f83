// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/accelerated_solve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thaw {
namespace {

/// Returns the nearest impulse whose normal part repels, with a tangential part within Coulomb's disc.
Vec3d projected(const Vec3d& impulse, const Vec3d& n, double friction) {
  const double along = dot(impulse, n), normal = std::max(0.0, along), most = friction * normal;
  if (!(most > 0)) return normal * n;
  const Vec3d tangential = impulse - along * n;
  const double square = dot(tangential, tangential);
  return normal * n + (square > most * most ? (most / std::sqrt(square)) * tangential : tangential);
}

/// A contact in the iteration. Velocities are relative changes by impulses. Iterates are the accepted one,
/// the one extrapolated from it, and the next one.
struct ContactIterate {
  Vec3d offset{};                                            ///< m/s, free velocity less the target
  Vec3d impulse{}, extrapolated{}, next{};                   ///< N s
  Vec3d velocity{}, extrapolatedVelocity{}, nextVelocity{};  ///< m/s
  double friction = 0;
};

enum Sum { Curvature, Size, Descent, sums };

struct Iteration {
  ContactSystem& system;
  FixedUnit energyUnit;
  std::vector<ContactIterate> contacts;
  std::vector<RowChange> nextRows;
  double stepFactor = 0.25;  ///< 1, of the inertia of mass splitting
  double momentum = 1;       ///< Nesterov's t
};

/// Sets the next iterate to the projected gradient step from the extrapolated one, and the changes of rows by
/// it. Returns the largest change in m/s. Collective.
double gradientStep(Iteration& it) {
  double largest = 0;  // squared
  clearImpulses(it.system);
  for (std::size_t i = 0; i < it.contacts.size(); i++) {
    const double inertia = it.stepFactor * it.system.inertia[i];
    if (!(inertia > 0)) continue;
    const RigidContact& c = it.system.contacts[i];
    ContactIterate& k = it.contacts[i];
    k.next = projected(k.extrapolated - (1 / inertia) * (k.offset + k.extrapolatedVelocity), c.normal,
                       k.friction);
    const Vec3d change = k.next - k.extrapolated;
    largest = std::max(largest, inertia * inertia * dot(change, change));
    addImpulse(it.system, c, k.next);
  }
  it.system.all->maximum({&largest, 1});
  applyImpulses(it.system, it.nextRows);
  return std::sqrt(largest);
}

/// Sets velocities of the next iterate. Returns sums over all contacts: (y'-y) N (y'-y), |y'-y|^2 in the
/// metric of mass splitting, and the last step times the gradient. The third is positive where momentum
/// overshoots. Collective.
ContactSums<sums> sumsOf(Iteration& it) {
  ContactSums<sums> s{it.energyUnit};
  for (std::size_t i = 0; i < it.contacts.size(); i++) {
    ContactIterate& k = it.contacts[i];
    const double inertia = it.system.inertia[i];
    k.nextVelocity = relativeChange(it.system.contacts[i], it.nextRows);
    const Vec3d change = k.next - k.extrapolated;
    s.add({dot(change, k.nextVelocity - k.extrapolatedVelocity), inertia * dot(change, change),
           -inertia * dot(change, k.next - k.impulse)});
  }
  s.sum(*it.system.all);
  return s;
}

/// Accepts the next iterate, and extrapolates from it unless the momentum overshoots.
void advance(Iteration& it, bool restart, std::vector<RowChange>& rows) {
  const double last = restart ? 1 : it.momentum;
  it.momentum = 0.5 * (1 + std::sqrt(1 + 4 * last * last));
  const double beta = restart ? 0 : (last - 1) / it.momentum;
  if (restart) it.momentum = 1;
  for (ContactIterate& k : it.contacts) {
    k.extrapolated = k.next + beta * (k.next - k.impulse);
    k.extrapolatedVelocity = k.nextVelocity + beta * (k.nextVelocity - k.velocity);
    k.impulse = k.next;
    k.velocity = k.nextVelocity;
  }
  std::swap(rows, it.nextRows);
}

/// Goes back to the last accepted iterate with a shorter step.
void reject(Iteration& it, double quotient) {
  it.stepFactor = std::min(1.0, 1.2 * quotient);
  it.momentum = 1;
  for (ContactIterate& k : it.contacts) {
    k.extrapolated = k.impulse;
    k.extrapolatedVelocity = k.velocity;
  }
}

/// Returns the first iterate, from guesses of the impulses. rows (out): its changes. Collective.
std::vector<ContactIterate> firstIterate(ContactSystem& system, const ContactConditions& conditions,
                                         std::span<Vec3d> impulses, std::vector<RowChange>& rows) {
  std::vector<ContactIterate> contacts(impulses.size());
  clearImpulses(system);
  for (std::size_t i = 0; i < impulses.size(); i++) {
    const RigidContact& c = system.contacts[i];
    const double friction = conditions.friction ? c.friction : 0;
    impulses[i] = system.inertia[i] > 0 ? projected(impulses[i], c.normal, friction) : Vec3d{};
    addImpulse(system, c, impulses[i]);
    contacts[i].offset = conditions.free[i] - conditions.target[i] * c.normal;
    contacts[i].impulse = contacts[i].extrapolated = contacts[i].next = impulses[i];
    contacts[i].friction = friction;
  }
  applyImpulses(system, rows);
  for (std::size_t i = 0; i < impulses.size(); i++)
    contacts[i].velocity = contacts[i].extrapolatedVelocity = relativeChange(system.contacts[i], rows);
  return contacts;
}

/// Largest energy |u|^2 / inertia of a contact, over all ranks: the scale of the sums.
double energyScale(const ContactSystem& system, const ContactConditions& conditions,
                   std::span<const Vec3d> impulses) {
  double largest = 0;
  for (std::size_t i = 0; i < impulses.size(); i++) {
    const double inertia = system.inertia[i];
    if (!(inertia > 0)) continue;
    const double u = length(conditions.free[i]) + std::abs(conditions.target[i]);
    largest = std::max(largest, u * u / inertia + inertia * dot(impulses[i], impulses[i]));
  }
  system.all->maximum({&largest, 1});
  return largest;
}

}  // namespace

SolveCount solveAccelerated(ContactSystem& system, const ContactConditions& conditions,
                            std::span<Vec3d> impulses, std::vector<RowChange>& rows) {
  std::vector<ContactIterate> first = firstIterate(system, conditions, impulses, rows);
  const double scale = energyScale(system, conditions, impulses);
  if (!(scale > 0)) return {};
  Iteration it{system, FixedUnit::forScale(scale), std::move(first), {}};
  SolveCount count;
  while (count.iterations < conditions.mostIterations) {
    count.iterations++;
    count.residual = gradientStep(it);
    const ContactSums<sums> s = sumsOf(it);
    const double quotient = s.value(Size) > 0 ? s.value(Curvature) / s.value(Size) : 0;
    if (quotient > 1.001 * it.stepFactor && it.stepFactor < 1) {
      reject(it, quotient);
      continue;
    }
    advance(it, s.value(Descent) > 0, rows);
    if (count.residual <= conditions.tolerance) break;
  }
  for (std::size_t i = 0; i < impulses.size(); i++) impulses[i] = it.contacts[i].impulse;
  return count;
}

}  // namespace thaw
