// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ledger/report.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/materials/contact_modulus.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/materials/state_equation.hpp"
#include "core/particles/elastic_pieces.hpp"
#include "core/simulation/ledger/ledger_rows.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "core/simulation/world/body_types.hpp"

namespace thaw {
namespace {

/// Adds the rotation of a particle of a rigid piece about its own centre.
void addOwnSpin(const Pieces& pieces, const Continuum& particles, const Scene& scene, std::size_t i,
                ExactBalance& b) {
  const std::uint32_t row = pieces.rowOf(particles.piece[i]);
  if (row == noPieceRow) return;  // at the start, before pieces are created
  const double inertia = ownInertia(particles.mass[i], scene.spacing);
  const Vec3d spin = spinOf(pieces, row, pieces.angularMomentum[row]);
  b.kinetic.add(0.5 * inertia * dot(spin, spin));
  for (int a = 0; a < 3; a++) b.angularMomentum[a].add(inertia * spin[a]);
}

void addRow(const World& w, std::size_t i, ExactBalance& b) {
  const Continuum& p = w.particles;
  const double m = p.mass[i];
  const Vec3d &x = p.position[i], &v = p.velocity[i], L = cross(x, v);
  b.mass.add(m);
  for (int a = 0; a < 3; a++) {
    b.momentum[a].add(m * v[a]);
    b.angularMomentum[a].add(m * L[a]);
  }
  b.kinetic.add(0.5 * m * dot(v, v));
  if (touchesAsPiece(p, i)) addOwnSpin(w.pieces, w.particles, w.scene, i, b);
  b.potential.add(-m * dot(w.scene.domain.gravity, x));
  if (p.interaction.active) b.potential.add(p.interaction[i]);
  if (p.enthalpy.active) b.internal.add(m * p.enthalpy[i]);
  if (p.solidIndex.active && p.solidIndex[i] != noSolid && w.solids.energy.active)
    b.elastic.add(w.solids.energy[p.solidIndex[i]]);
}

/// Exact sums, packed for a single reduction.
struct Pack {
  std::vector<ExactSum> sums;
  void add(const ExactBalance& b) {
    sums.push_back(b.mass);
    for (int a = 0; a < 3; a++) sums.push_back(b.momentum[a]);
    for (int a = 0; a < 3; a++) sums.push_back(b.angularMomentum[a]);
    for (const ExactSum* s : {&b.kinetic, &b.elastic, &b.potential, &b.internal}) sums.push_back(*s);
  }
};

struct Unpack {
  const std::vector<ExactSum>& sums;
  std::size_t at = 0;
  double next() { return sums[at++].value(); }
  Vec3d next3() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }
  Balance balance() {
    Balance b;
    b.mass = next();
    b.momentum = next3();
    b.angularMomentum = next3();
    b.kinetic = next();
    b.elastic = next();
    b.potential = next();
    b.internal = next();
    return b;
  }
};

double mechanical(const Balance& b) { return b.kinetic + b.elastic + b.potential; }

/// Heat (J) that temperature differences in the scene can move.
double movableHeat(const Scene& s, const Modules& modules, double mass) {
  if (!modules.heat) return 0;
  double lowest = never, highest = -never, capacity = 0;
  const auto see = [&](double T) { lowest = std::min(lowest, T), highest = std::max(highest, T); };
  for (const Body& b : s.bodies) {
    const double half = 0.5 * length(b.temperatureGradient) * length(s.domain.max - s.domain.min);
    see(b.temperature - half), see(b.temperature + half);
  }
  for (const Emitter& e : s.emitters) see(e.temperature);
  for (const Thermostat& t : s.thermostats) see(t.temperature);
  for (const Obstacle& o : s.obstacles)
    if (o.temperature) see(*o.temperature);
  for (const Material& m : s.materials) {
    if (m.convection > 0 || m.emissivity > 0) see(s.domain.ambient);
    capacity = std::max({capacity, m.heatCapacity.solid, m.heatCapacity.liquid});
  }
  return highest > lowest ? mass * capacity * (highest - lowest) : 0;
}

/// The larger of the heat (J) that has moved and the heat that can move.
double heatScaleOf(const Scene& scene, const Modules& modules, const LedgerReport& r) {
  const double gained = r.now.internal - r.initial.internal - r.entered.internal + r.left.internal;
  return std::max({std::abs(gained), std::abs(r.heatIn), movableHeat(scene, modules, r.now.mass)});
}

/// Rounding limit (J) of mechanical energies, which are sums of cancelling terms. It is 1e-14 of three
/// energies. These belong to a strain of 1 in all bodies, their fall through the domain, and motion through
/// the domain in the scene's duration. It is at least 2^-24 of the heat that moves. Smaller energies are
/// invisible in the temperatures of a frame, which are in single precision.
double roundingOf(const Scene& s, const Modules& modules, const SheetBodies& sheets,
                  const std::vector<LiquidMaterial>& liquids, const LedgerReport& r) {
  const Vec3d size = s.domain.max - s.domain.min;
  double fall = 0, strained = 0;
  for (int a = 0; a < 3; a++) fall += std::abs(s.domain.gravity[a]) * size[a];
  for (std::size_t k = 0; k < s.materials.size() && r.particles > 0; k++) {
    const Material& m = s.materials[k];
    if (m.canBeSolid()) strained = std::max(strained, contactModulus(m, 0) / m.density * r.now.mass);
    if (modules.fluid && k < liquids.size())
      strained = std::max(strained, liquids[k].stiffness / m.density * r.now.mass);
  }
  for (const OrientedBody& b : s.oriented) {
    const double spacing = spacingOf(s, b);
    strained = std::max(strained,
                        b.stiffness * spacing * spacing * static_cast<double>(r.rows[orientedType]));
  }
  for (std::size_t n = 0; n < sheets.plans.size(); n++) {
    const SheetBody& b = s.sheets[n];
    double area = 0;
    for (const double x : sheets.plans[n].topology.area) area += x;
    strained = std::max(strained, area * std::max({b.warp, b.weft, b.shear, b.bending}));
  }
  const double speed = s.end > 0 ? length(size) / s.end : 0;
  const double mechanical = std::max({strained, r.now.mass * fall, 0.5 * r.now.mass * speed * speed});
  return std::max(1e-14 * mechanical, std::ldexp(r.heatScale, -24));
}

}  // namespace

void addToBalance(const World& w, std::span<const std::uint32_t> rows, ExactBalance& b) {
  for (std::uint32_t i : rows) addRow(w, i, b);
}

ExactBalance balanceHere(const World& w) {
  ExactBalance now;
  for (std::size_t i = 0; i < w.particles.owned; i++) addRow(w, i, now);
  forEachBodyType(w, [&](std::size_t kind, const BodyTypeRows& r, const CellTable&) {
    for (std::size_t i = 0; i < r.owned; i++) addBodyTypeRow(w, kind, i, now);
  });
  return now;
}

namespace {

/// Returns this rank's part of all sums of a report, in the order that unpackReport expects.
Pack packLedger(const World& w) {
  const Continuum& p = w.particles;
  ExactSum dissipated = w.ledger.dissipated, liquid, continuum, impulseInFlight[3];
  for (std::size_t i = 0; i < p.owned; i++) {
    dissipated.add(p.dissipated[i]);
    continuum.add(p.mass[i]);
    liquid.add(p.liquid.active        ? p.mass[i] * static_cast<double>(p.liquid[i])
               : p.phase[i] == Liquid ? p.mass[i]
                                      : 0.0);
  }
  forEachBodyType(w, [&](std::size_t, const BodyTypeRows& r, const CellTable&) {
    for (std::size_t i = 0; i < r.owned; i++) dissipated.add(r.dissipated[i]);
  });
  const Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned && o.external.active; i++)
    for (int a = 0; a < 3; a++) impulseInFlight[a].add(0.5 * w.clock.stepDt * o.external[i][a]);
  Pack pack;
  pack.add(balanceHere(w));
  pack.add(w.ledger.entered);
  pack.add(w.ledger.left);
  for (const ExactSum& s : {dissipated, w.ledger.wallWork, w.ledger.heatIn, w.ledger.phaseJump,
                            w.ledger.restartJump, liquid, continuum})
    pack.sums.push_back(s);
  if (w.modules.lamps)
    for (const SourceSums* s : {&w.ledger.lamps, &w.ledger.lasers, &w.ledger.regions})
      for (const ExactSum& part : {s->given, s->absorbed, s->reflected}) pack.sums.push_back(part);
  if (w.modules.evaporation)
    for (const ExactSum& s : {w.ledger.evaporated, w.ledger.vapourHeat}) pack.sums.push_back(s);
  for (const ExactSum& s : w.ledger.wallImpulse) pack.sums.push_back(s);
  for (const ExactSum& s : w.ledger.gravityImpulse) pack.sums.push_back(s);
  for (const ExactSum& s : impulseInFlight) pack.sums.push_back(s);
  return pack;
}

/// Sums of a report over all ranks, and the numbers of rows.
struct LedgerSums {
  std::vector<ExactSum> sums;
  std::vector<std::int64_t> counts;  ///< rows of each body type in the scene, then continuum particles
};

/// Reduces all sums and counts over ranks in one reduction. Collective.
LedgerSums sumOverRanks(const World& w, Pack pack, Reducer& all) {
  std::vector<std::int64_t> digits;
  for (ExactSum& s : pack.sums) {
    s.carry();
    digits.insert(digits.end(), s.digit.begin(), s.digit.end());
  }
  forEachBodyType(w, [&](std::size_t, const BodyTypeRows& r, const CellTable&) {
    digits.push_back(static_cast<std::int64_t>(r.owned));
  });
  digits.push_back(static_cast<std::int64_t>(w.particles.owned));
  all.sum(digits);
  for (std::size_t k = 0; k < pack.sums.size(); k++)
    std::copy_n(digits.data() + k * ExactSum::digits, ExactSum::digits, pack.sums[k].digit.data());
  digits.erase(digits.begin(),
               digits.begin() + static_cast<std::ptrdiff_t>(pack.sums.size() * ExactSum::digits));
  return {std::move(pack.sums), std::move(digits)};
}

/// Returns the report without residuals and scales.
LedgerReport unpackReport(const World& w, const LedgerSums& from) {
  Unpack u{from.sums};
  LedgerReport r;
  r.particles = from.counts.back();
  std::size_t counted = 0;
  forEachBodyType(w, [&](std::size_t kind, const BodyTypeRows&, const CellTable&) {
    r.rows[kind] = from.counts[counted++];
  });
  r.now = u.balance();
  r.entered = u.balance();
  r.left = u.balance();
  r.dissipated = u.next();
  r.wallWork = u.next();
  r.heatIn = u.next();
  r.phaseJump = u.next();
  r.restartJump = u.next();
  const double liquidMass = u.next(), continuumMass = u.next();
  r.liquidFraction = continuumMass > 0 ? liquidMass / continuumMass : 0;
  r.hasSources = w.modules.lamps;
  if (r.hasSources)
    for (SourceReport* s : {&r.lamps, &r.lasers, &r.regions})
      for (double* part : {&s->given, &s->absorbed, &s->reflected}) *part = u.next();
  r.hasVapour = w.modules.evaporation;
  if (r.hasVapour)
    for (double* one : {&r.evaporated, &r.vapourHeat}) *one = u.next();
  r.wallImpulse = u.next3();
  r.initial = w.ledger.initial;
  r.gravityImpulse = u.next3() + w.scene.domain.gravity * (r.initial.mass * w.clock.time);
  r.impulseInFlight = u.next3();
  return r;
}

/// Sets the residuals, which no entry explains, and the energy scales for their comparison.
void findResiduals(const MonitorState& monitor, LedgerReport& r) {
  r.massResidual = r.now.mass - (r.initial.mass + r.entered.mass - r.left.mass);
  r.momentumResidual = r.now.momentum + r.impulseInFlight -
                       (r.initial.momentum + r.entered.momentum - r.left.momentum + r.wallImpulse +
                        r.gravityImpulse);
  const double expected = mechanical(r.initial) + mechanical(r.entered) - mechanical(r.left) + r.wallWork -
                          r.dissipated - r.phaseJump + r.restartJump;
  r.energyResidual = mechanical(r.now) - expected;
  r.energyScale = std::max({std::abs(r.now.kinetic), std::abs(r.initial.kinetic), std::abs(r.dissipated),
                            std::abs(r.now.potential - r.initial.potential), std::abs(r.now.elastic),
                            std::abs(r.wallWork), r.entered.kinetic, r.left.kinetic});
  r.energyLargest = std::max(r.energyScale, monitor.largest);
  r.heatResidual = r.now.internal - (r.initial.internal + r.entered.internal - r.left.internal + r.heatIn);
}

}  // namespace

LedgerReport reportLedger(World& w, const StepTools& t, Reducer& all) {
  findStoredEnergy(w, t);
  LedgerReport r = unpackReport(w, sumOverRanks(w, packLedger(w), all));
  findResiduals(w.monitor, r);
  r.heatScale = heatScaleOf(w.scene, w.modules, r);
  r.energyRounding = roundingOf(w.scene, w.modules, w.sheets, t.liquids, r);
  return r;
}

}  // namespace thaw
