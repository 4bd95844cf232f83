// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/accelerated_solve.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

/// Returns the nearest impulse whose normal part repels, with a tangential part within Coulomb's disc.
Vec3d projected(const Vec3d& impulse, const RigidContact& c, double friction) {
  const double normal = std::max(0.0, dot(impulse, c.normal));
  const Vec3d tangential = impulse - dot(impulse, c.normal) * c.normal;
  const double size = length(tangential), most = friction * normal;
  if (!(most > 0)) return normal * c.normal;
  return normal * c.normal + (size > most ? (most / size) * tangential : tangential);
}

double frictionOf(const ContactConditions& conditions, const RigidContact& c) {
  return conditions.friction ? c.friction : 0;
}

enum Sum { Curvature, Size, Descent, sums };

struct Iteration {
  ContactSystem& system;
  const ContactConditions& conditions;
  FixedUnit energyUnit;
  std::vector<Vec3d> extrapolated, next;
  std::vector<RowChange> extrapolatedRows, nextRows;
  double stepFactor = 0.25;  ///< 1, of the inertia of mass splitting
  double momentum = 1;       ///< Nesterov's t
};

/// Sets `next` to the projected gradient step from `extrapolated`; returns the largest change in m/s.
double gradientStep(Iteration& it) {
  double largest = 0;
  for (std::size_t i = 0; i < it.system.contacts.size(); i++) {
    const RigidContact& c = it.system.contacts[i];
    const double inertia = it.stepFactor * it.system.inertia[i];
    if (!(inertia > 0)) continue;
    const Vec3d u = it.conditions.free[i] + relativeChange(c, it.extrapolatedRows) -
                    it.conditions.target[i] * c.normal;
    it.next[i] = projected(it.extrapolated[i] - u / inertia, c, frictionOf(it.conditions, c));
    largest = std::max(largest, inertia * length(it.next[i] - it.extrapolated[i]));
  }
  return largest;
}

/// Sums over all contacts: (y'-y) N (y'-y), |y'-y|^2 in the metric of mass splitting, and the last step times
/// the gradient. The third is positive where momentum overshoots.
ContactSums<sums> sumsOf(const Iteration& it, std::span<const Vec3d> impulses) {
  ContactSums<sums> s{it.energyUnit, {}};
  std::vector<RowChange> difference(it.nextRows.size());
  for (std::size_t r = 0; r < difference.size(); r++)
    difference[r] = {it.nextRows[r].velocity - it.extrapolatedRows[r].velocity,
                     it.nextRows[r].spin - it.extrapolatedRows[r].spin};
  for (std::size_t i = 0; i < it.system.contacts.size(); i++) {
    const Vec3d change = it.next[i] - it.extrapolated[i];
    s.add(Curvature, dot(change, relativeChange(it.system.contacts[i], difference)));
    s.add(Size, it.system.inertia[i] * dot(change, change));
    s.add(Descent, -it.system.inertia[i] * dot(change, it.next[i] - impulses[i]));
  }
  s.sum(*it.system.all);
  return s;
}

/// Accepts `next`, and extrapolates from it unless the momentum overshoots.
void advance(Iteration& it, bool restart, std::span<Vec3d> impulses, std::vector<RowChange>& rows) {
  const double last = restart ? 1 : it.momentum;
  it.momentum = 0.5 * (1 + std::sqrt(1 + 4 * last * last));
  const double beta = restart ? 0 : (last - 1) / it.momentum;
  if (restart) it.momentum = 1;
  for (std::size_t i = 0; i < it.next.size(); i++) {
    it.extrapolated[i] = it.next[i] + beta * (it.next[i] - impulses[i]);
    impulses[i] = it.next[i];
  }
  for (std::size_t r = 0; r < rows.size(); r++) {
    const RowChange &to = it.nextRows[r], &from = rows[r];
    it.extrapolatedRows[r] = {to.velocity + beta * (to.velocity - from.velocity),
                              to.spin + beta * (to.spin - from.spin)};
    rows[r] = to;
  }
}

/// Goes back to the last accepted impulses with a shorter step.
void reject(Iteration& it, double quotient, std::span<const Vec3d> impulses,
            const std::vector<RowChange>& rows) {
  it.stepFactor = std::min(1.0, 1.2 * quotient);
  it.momentum = 1;
  std::copy(impulses.begin(), impulses.end(), it.extrapolated.begin());
  it.extrapolatedRows = rows;
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
  for (std::size_t i = 0; i < impulses.size(); i++)
    impulses[i] = system.inertia[i] > 0
                      ? projected(impulses[i], system.contacts[i], frictionOf(conditions, system.contacts[i]))
                      : Vec3d{};
  applyImpulses(system, impulses, rows);
  const double scale = energyScale(system, conditions, impulses);
  if (!(scale > 0)) return {};
  Iteration it{system,
               conditions,
               FixedUnit::forScale(scale),
               {impulses.begin(), impulses.end()},
               {impulses.begin(), impulses.end()},
               rows,
               rows};
  SolveCount count;
  while (count.iterations < conditions.mostIterations) {
    count.iterations++;
    count.residual = gradientStep(it);
    system.all->maximum({&count.residual, 1});
    applyImpulses(system, it.next, it.nextRows);
    const ContactSums<sums> s = sumsOf(it, impulses);
    const double quotient = s.value(Size) > 0 ? s.value(Curvature) / s.value(Size) : 0;
    if (quotient > 1.001 * it.stepFactor && it.stepFactor < 1) {
      reject(it, quotient, impulses, rows);
      continue;
    }
    advance(it, s.value(Descent) > 0, impulses, rows);
    if (count.residual <= conditions.tolerance) break;
  }
  return count;
}

}  // namespace thaw
