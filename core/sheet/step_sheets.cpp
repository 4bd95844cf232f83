// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/step_sheets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sheet/contact/mesh_contact.hpp"
#include "core/sheet/contact/sheet_contact.hpp"
#include "core/sheet/data/touching_sheets.hpp"
#include "core/sheet/forces/cell_sums.hpp"
#include "core/sheet/forces/inner_forces.hpp"
#include "core/sheet/forces/outer_forces.hpp"
#include "core/sheet/forces/time_factors.hpp"
#include "core/sheet/move_vertices.hpp"
#include "core/sheet/shrink_wrap/shrink_wrap.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

/// Returns a law's coefficients at the middle of the step that begins now.
SpringLaw lawNow(const Scene& scene, const Clock& clock, const SheetLaw& l, double dt) {
  const SheetBody& b = scene.sheets[l.sheet];
  const double time = clock.time + 0.5 * dt;
  return {l.law.mass, l.law.damping * b.factorAt(SheetFactor::Damping, time),
          l.law.stiffness * b.factorAt(SheetFactor::Stiffness, time)};
}

/// Returns the law for the least stable case of the next step: smallest damping and largest stiffness.
SpringLaw leastStableLaw(const Scene& scene, const Clock& clock, const SheetLaw& l) {
  const SheetBody& b = scene.sheets[l.sheet];
  const double until = clock.time + 1.1 * clock.dt;
  return {l.law.mass, l.law.damping * b.inTime[placeOf(SheetFactor::Damping)].least(clock.time, until),
          l.law.stiffness * b.inTime[placeOf(SheetFactor::Stiffness)].most(clock.time, until)};
}

/// Records the work of changes of the rest springs between two times (s), at the current positions.
void recordRestChange(const SheetView& w, double from, double to) {
  std::vector<double> half;
  bool any = false;
  for (const SheetLaw& l : w.sheets.laws) {
    const SheetBody& b = w.scene.sheets[l.sheet];
    half.push_back(0.5 * l.law.stiffness *
                   (b.factorAt(SheetFactor::Stiffness, to) - b.factorAt(SheetFactor::Stiffness, from)));
    any = any || half.back() != 0;
  }
  if (!any) return;
  const Sheets& s = w.sheets.rows;
  addByCell(w.sheets.cells, s.owned, w.ledger.wallWork, [&](std::size_t i) {
    Vec3d z = s.position[i] - s.rest[i];
    if (s.flow.active) z -= s.flow[i];
    return half[s.law[i]] * s.area[i] * dot(z, z);
  });
}

std::vector<SpringLaw> lawsNow(const SheetView& w, double dt) {
  std::vector<SpringLaw> laws;
  for (const SheetLaw& l : w.sheets.laws) laws.push_back(lawNow(w.scene, w.clock, l, dt));
  return laws;
}

Vec3d restOf(const Sheets& s, std::size_t i) {
  if (!s.flow.active) return s.rest[i];
  return s.rest[i] + s.flow[i];
}

/// Applies plastic flow beyond the elastic limit. Plasticity times the excess moves the rest position, and
/// the remainder raises the limit. The vertex is then at the limit, so the result does not depend on the
/// number of steps.
void applyPlasticFlow(SheetBodies& sheets, const Scene& scene, double time) {
  Sheets& s = sheets.rows;
  for (std::size_t i = 0; i < s.owned; i++) {
    const SheetBody& b = scene.sheets[s.body[i]];
    if (!(b.plasticity > 0) || !(b.elasticLimit < never)) continue;
    const Vec3d before = s.position[i] - restOf(s, i);
    const double far = length(before), excess = far - b.elasticLimit - s.hardening[i];
    if (!(excess > 0)) continue;
    const double k = sheets.laws[s.law[i]].law.stiffness * b.factorAt(SheetFactor::Stiffness, time) *
                     s.area[i];
    s.flow[i] += before * (b.plasticity * excess / far);
    s.hardening[i] += (1 - b.plasticity) * excess;
    const Vec3d after = s.position[i] - restOf(s, i);
    s.dissipated[i] += 0.5 * k * (dot(before, before) - dot(after, after));
  }
}

/// Returns the damping load whose work counts as dissipation. For vertices without mass, it excludes dashpots
/// and friction. Their velocity alternates with these forces, so force times velocity is not the work.
Vec3d loadForDamping(const Sheets& s, std::size_t i, const SpringLaw& law) {
  return s.dissipativeForce.active && !(law.mass > 0) ? s.load[i] - s.dissipativeForce[i] : s.load[i];
}

/// Records dissipation of dashpots and friction over half of a step, with the displacement (m) of that half.
/// A force acts for half of the step that ends with it, and for half of the next. It must therefore not be
/// recorded earlier.
void recordDissipation(Sheets& s, std::size_t i, const SpringLaw& law, const Vec3d& way) {
  if (s.dissipativeForce.active && law.mass > 0)
    s.dissipated[i] -= s.area[i] * dot(s.dissipativeForce[i], way);
}

/// Records a vertex's dissipation at the end of a step: dashpots and friction. With damping, it also includes
/// the work of the load minus the change of energy.
void recordKickDissipation(Sheets& s, std::size_t i, const SpringLaw& law, double dt) {
  const Vec3d& v = s.velocity[i];
  // the dissipation of damping is the missing work over the same displacement
  recordDissipation(s, i, law, law.damping > 0 ? 0.5 * s.moved[i] : 0.5 * dt * v);
  if (law.damping > 0)
    s.dissipated[i] += s.area[i] *
                       (0.5 * dot(loadForDamping(s, i, law), s.moved[i]) - 0.5 * law.mass * dot(v, v));
}

}  // namespace

void moveSheets(const SheetView& w, double dt) {
  Sheets& s = w.sheets.rows;
  const std::vector<SpringLaw> laws = lawsNow(w, dt);
  std::vector<VertexMap> maps;
  for (const SpringLaw& l : laws) maps.push_back(vertexMap(l, dt));
  recordConstraintImpulse(w.sheets, w.ledger, -1, dt);
  const double begin = w.clock.time, middle = begin + 0.5 * dt, end = begin + dt;
  recordRestChange(w, begin, middle);  // over the step, coefficients have their values at its middle
  recordFactorWork(w.sheets, w.scene, w.ledger, begin, end);
  const bool simple = !s.flow.active && !s.clamped.active && !s.moved.active && !s.dissipativeForce.active;
  if (simple) {
    moveVertices(maps, {s.position.data(), s.velocity.data(), s.rest.data(), s.load.data(), s.law.data()}, 0,
                 s.owned);
    recordRestChange(w, middle, end);
    return;
  }
  for (std::size_t i = 0; i < s.owned; i++) {
    if (s.moved.active) s.moved[i] = {};
    if (s.clamped.active && s.clamped[i]) continue;
    const VertexMap& m = maps[s.law[i]];
    const SpringLaw& law = laws[s.law[i]];
    const Vec3d rest = restOf(s, i), z = s.position[i] - rest, v = s.velocity[i];
    const VertexArrays one{&s.position[i], &s.velocity[i], &rest, &s.load[i], nullptr};
    moveVertices({&m, 1}, one, 0, 1);
    const Vec3d z1 = s.position[i] - rest, moved = z1 - z;
    recordDissipation(s, i, law, law.damping > 0 ? 0.5 * moved : 0.5 * dt * v);
    if (!s.moved.active) continue;
    s.moved[i] = moved;
    // the dissipation of damping is the load's work minus the change of energy; kickSheets records the second
    // half
    if (law.damping > 0)
      s.dissipated[i] += s.area[i] *
                         (0.5 * law.mass * dot(v, v) + 0.5 * law.stiffness * (dot(z, z) - dot(z1, z1)) +
                          0.5 * dot(loadForDamping(s, i, law), moved));
  }
  if (s.outside.active) recordExternalWork(w.sheets, w.ledger);
  recordRestChange(w, middle, end);
  if (s.flow.active) applyPlasticFlow(w.sheets, w.scene, end);
}

void kickSheets(const SheetView& w, double dt) {
  Sheets& s = w.sheets.rows;
  // Laws of the step that ends now, since the clock still shows its beginning.
  const std::vector<SpringLaw> laws = lawsNow(w, dt);
  std::vector<double> after;
  for (const SpringLaw& l : laws) after.push_back(vertexMap(l, dt).after);
  for (std::size_t i = 0; i < s.owned; i++) {
    if (s.clamped.active && s.clamped[i]) continue;
    Vec3d& v = s.velocity[i];
    v += after[s.law[i]] * s.load[i];
    recordKickDissipation(s, i, laws[s.law[i]], dt);
  }
  recordConstraintImpulse(w.sheets, w.ledger, 1, dt);
  if (s.outside.active) recordExternalWork(w.sheets, w.ledger);
  if (s.temperature.active)
    for (std::size_t i = 0; i < s.owned; i++)
      s.temperature[i] += s.heatFlow[i] * dt / (s.area[i] * w.scene.sheets[s.body[i]].heatCapacity);
}

void finaliseRemoved(const SheetView& w, std::span<const std::uint32_t> rows, double dt) {
  Sheets& s = w.sheets.rows;
  if (rows.empty() || !(dt > 0)) return;
  const std::vector<SpringLaw> laws = lawsNow(w, dt);
  for (const std::uint32_t i : rows) {
    const SpringLaw& law = laws[s.law[i]];
    const bool clamped = s.clamped.active && s.clamped[i];
    if (clamped || (!(law.damping > 0) && !(law.stiffness > 0))) continue;
    Vec3d& v = s.velocity[i];
    v += vertexMap(law, dt).after * s.load[i];
    const Vec3d impulse = s.mass[i] * v;
    for (int a = 0; a < 3; a++) w.ledger.wallImpulse[a].add(impulse[a]);
    if (!s.moved.active) continue;
    const Vec3d moved = s.moved[i], z1 = s.position[i] - restOf(s, i), z = z1 - moved;
    s.energy[i] += 0.5 * law.stiffness * s.area[i] * (dot(z1, z1) - dot(z, z));
    if (s.outside.active) w.ledger.wallWork.add(0.5 * dot(s.outside[i], moved) * s.area[i]);
    recordKickDissipation(s, i, law, dt);
  }
}

void linkSheets(SheetBodies& b, Halos halos, PhaseTimes& times) {
  Sheets& s = b.rows;
  const BondedRows rows = vertexRows(s);
  linkSolids(rows, b.edges.ends);
  halos.edges->rebuildBonds(rows, b.edges.ends, b.edges.bonds, {{}, b.leftHere || b.edgesAtStart});
  b.leftHere = false;
  if (b.edgesAtStart) {
    const std::vector<BondRequest> requests = edgeRequests(b);
    halos.edges->rebuildBonds(rows, b.edges.ends, b.edges.bonds, {requests, true});
    b.edgesAtStart = false;
  }
  times.lap(StepPhase::Bonds);
}

void loadSheets(const SheetView& w, Halos halos, PhaseTimes& times, double dt) {
  SheetBodies& b = w.sheets;
  Sheets& s = b.rows;
  b.stiffest.assign(b.laws.size(), 0);
  b.slope.assign(s.owned, 0);
  b.fastest2 = b.largestAcceleration = b.stiffestParticle = b.closingRate = b.impactRate = 0;
  // contacts need the current velocity, for which the load before the step approximates the load after it
  std::vector<double> after(b.laws.size(), 0);
  for (std::size_t l = 0; dt > 0 && l < b.laws.size(); l++)
    after[l] = vertexMap(lawNow(w.scene, w.clock, b.laws[l], dt), dt).after;
  SheetVelocities now;
  now.velocity.swap(b.velocityBuffer);
  now.velocity.resize(s.owned);
  for (std::size_t i = 0; i < s.owned; i++)
    now.velocity[i] = s.clamped.active && s.clamped[i] ? Vec3d{}
                                                       : s.velocity[i] + after[s.law[i]] * s.load[i];
  now.span = dt > 0 ? dt : nextStep(w.clock);
  now.dt = dt;

  updateTimeFactors(b, w.scene, w.clock, dt);
  clearLoads(b, w.scene);
  addInnerForces(b, w.scene, halos);
  times.lap(StepPhase::Sheet);
  addOuterForces(w, now);
  addShrinkWrap(w, halos, now);
  addSheetContacts(w, halos, now);
  times.lap(StepPhase::SheetContact);
  b.fastestDrag = fastestDrag(b, w.scene, now);
  addRestEnergy(b, w.scene, w.clock.time + dt);
  if (dt > 0) recordFactorWork(b, w.scene, w.ledger, w.clock.time, w.clock.time + dt);
  for (std::size_t i = 0; i < s.owned; i++) b.stiffest[s.law[i]] = std::max(b.stiffest[s.law[i]], b.slope[i]);
  for (std::size_t i = 0; i < s.owned; i++)
    if (w.sheets.plans[s.body[i]].touches) {
      b.fastest2 = std::max(b.fastest2, dot(now.velocity[i], now.velocity[i]));
      if (s.mass[i] > 0 && !(s.clamped.active && s.clamped[i]))
        b.largestAcceleration = std::max(b.largestAcceleration, length(s.load[i]) * s.area[i] / s.mass[i]);
    }
  now.velocity.swap(b.velocityBuffer);
  times.lap(StepPhase::Sheet);
}

double sheetStepLimit(const SheetBodies& b, const Scene& scene, const Clock& clock) {
  double limit = never;
  for (std::size_t l = 0; l < b.stiffest.size(); l++) {
    if (!(b.stiffest[l] > 0)) continue;
    // rounded up to one of 32 values per octave, so ranks with similar stiffness agree and the step does not
    // fluctuate
    int e = 0;
    const double part = std::frexp(b.stiffest[l], &e), kappa = std::ldexp(std::ceil(part * 64) / 64, e);
    limit = std::min(
        limit, 2 * scene.numerics.cflElastic * stableStep(leastStableLaw(scene, clock, b.laws[l]), kappa));
  }
  for (std::size_t l = 0; l < b.laws.size(); l++) {
    const SpringLaw& law = b.laws[l].law;
    // kappa is a bound, about four times the typical squared frequency
    const double kappa = l < b.stiffest.size() ? b.stiffest[l] : 0,
                 of = law.mass > 0      ? 0.5 * std::sqrt(kappa / law.mass)
                      : law.damping > 0 ? kappa / law.damping
                                        : 0;
    const SheetBody& body = scene.sheets[b.laws[l].sheet];
    limit = std::min(limit, timeFactorStepLimit(body, clock.time, fastestRate(body, law, clock.time), of));
  }
  if (b.stiffestParticle > 0) {
    int e = 0;
    const double part = std::frexp(b.stiffestParticle, &e);
    limit = std::min(limit,
                     4 * scene.numerics.cflElastic / std::sqrt(std::ldexp(std::ceil(part * 64) / 64, e)));
  }
  if (b.fastestDrag > 0) limit = std::min(limit, dragInAStep / b.fastestDrag);
  // no vertex may pass through another object in one step
  if (b.fastest2 > 0 || b.largestAcceleration > 0) {
    double thin = never;
    for (const SheetPlan& p : b.plans)
      // two sheets may both approach
      if (p.touches)
        thin = std::min(
            {thin, (meshesTouch(scene) ? 0.5 : 1) * p.thickness, p.byFaces ? p.faceReach : never});
    limit = std::min({limit, 0.5 * thin / std::sqrt(b.fastest2),
                      b.largestAcceleration > 0 ? std::sqrt(thin / b.largestAcceleration) : never});
  }
  if (b.impactRate > 0) limit = std::min(limit, 1 / b.impactRate);
  if (b.closingRate > 0) limit = std::min(limit, 0.5 / b.closingRate);
  return limit;
}

}  // namespace thaw
