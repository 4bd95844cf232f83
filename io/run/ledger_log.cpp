// SPDX-License-Identifier: Apache-2.0
#include "io/run/ledger_log.hpp"

#include <cmath>
#include <fstream>
#include <vector>

#include "core/simulation/ledger/report.hpp"
#include "core/simulation/ledger/stored_parts.hpp"
#include "core/time/frame_times.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/run/reports/step_log.hpp"

namespace thaw {
namespace {

/// Columns: names with units, and values in as many digits as make them unique.
class Columns {
 public:
  template<class Value> void add(const std::string& name, const Value& value) {
    list_.push_back({name, fmt::format("{}", value), static_cast<double>(value)});
  }
  void add(const std::string& name, const char* unit, const Vec3d& v) {
    for (int a = 0; a < 3; a++) add(fmt::format("{}_{}_{}", name, "xyz"[a], unit), v[a]);
  }
  std::string head() const {
    return joined([](const Column& c) { return c.name; });
  }
  std::string row() const {
    return joined([](const Column& c) { return c.text; });
  }
  void addTo(LedgerHistory& history, std::int64_t step) const {
    std::vector<double> values;
    for (const Column& c : list_) values.push_back(c.value);
    if (history.names.empty())
      for (const Column& c : list_) history.names.push_back(c.name);
    history.rows.push_back({step, std::move(values)});
  }

 private:
  struct Column {
    std::string name, text;
    double value;
  };
  template<class Field> std::string joined(Field&& field) const {
    std::string line;
    for (const Column& c : list_) line += (line.empty() ? "" : ",") + field(c);
    return line + "\n";
  }
  std::vector<Column> list_;
};

void addMass(Columns& c, const LedgerReport& l) {
  c.add("particles", l.particles);
  for (std::size_t k = 0; k < bodyTypeCount; k++) c.add(bodyTypeNames[k], l.rows[k]);
  c.add("liquid_fraction", l.liquidFraction);
  c.add("mass_kg", l.now.mass);
  c.add("entered_mass_kg", l.entered.mass);
  c.add("left_mass_kg", l.left.mass);
  c.add("mass_residual_kg", l.massResidual);
}

void addMomentum(Columns& c, const LedgerReport& l) {
  c.add("momentum", "kg_m_per_s", l.now.momentum);
  c.add("entered_momentum", "kg_m_per_s", l.entered.momentum);
  c.add("left_momentum", "kg_m_per_s", l.left.momentum);
  c.add("wall_impulse", "N_s", l.wallImpulse);
  c.add("gravity_impulse", "N_s", l.gravityImpulse);
  c.add("impulse_in_flight", "N_s", l.impulseInFlight);
  c.add("momentum_residual", "kg_m_per_s", l.momentumResidual);
  c.add("angular_momentum", "kg_m2_per_s", l.now.angularMomentum);
}

void addEnergy(Columns& c, const LedgerReport& l, const StoredParts& parts) {
  c.add("kinetic_J", l.now.kinetic);
  c.add("elastic_J", l.now.elastic);
  c.add("potential_J", l.now.potential);
  c.add("gravity_J", parts.gravity);
  c.add("compression_J", parts.compression);
  c.add("surface_tension_J", parts.tension);
  c.add("contact_J", parts.contact);
  c.add("dissipated_J", l.dissipated);
  c.add("wall_work_J", l.wallWork);
  c.add("phase_jump_J", l.phaseJump);
  c.add("restart_jump_J", l.restartJump);
  for (const auto& [name, flow] : {std::pair{"entered", &l.entered}, std::pair{"left", &l.left}}) {
    c.add(fmt::format("{}_kinetic_J", name), flow->kinetic);
    c.add(fmt::format("{}_elastic_J", name), flow->elastic);
    c.add(fmt::format("{}_potential_J", name), flow->potential);
  }
  c.add("energy_residual_J", l.energyResidual);
  c.add("energy_scale_J", l.energyLargest);
  c.add("energy_rounding_J", l.energyRounding);
}

void addHeat(Columns& c, const LedgerReport& l) {
  c.add("internal_J", l.now.internal);
  c.add("heat_in_J", l.heatIn);
  const std::pair<const char*, const SourceReport*> sources[] = {
      {"lamps", &l.lamps}, {"lasers", &l.lasers}, {"regions", &l.regions}};
  for (const auto& [name, source] : sources) {
    if (!l.hasSources) break;
    c.add(fmt::format("{}_given_J", name), source->given);
    c.add(fmt::format("{}_absorbed_J", name), source->absorbed);
    c.add(fmt::format("{}_reflected_J", name), source->reflected);
  }
  c.add("entered_internal_J", l.entered.internal);
  c.add("left_internal_J", l.left.internal);
  if (l.hasVapour) {
    c.add("evaporated_mass_kg", l.evaporated);
    c.add("vapour_heat_J", l.vapourHeat);
  }
  c.add("heat_residual_J", l.heatResidual);
  c.add("heat_scale_J", l.heatScale);
}

Columns columnsOf(const Clock& clock, const LedgerReport& ledger, const StoredParts& parts) {
  Columns c;
  c.add("step", clock.step);
  c.add("time_s", clock.time);
  c.add("dt_s", clock.stepDt);
  addMass(c, ledger);
  addMomentum(c, ledger);
  addEnergy(c, ledger, parts);
  addHeat(c, ledger);
  return c;
}

std::string head(const Modules& modules) {
  LedgerReport ledger;
  ledger.hasSources = modules.lamps;
  ledger.hasVapour = modules.evaporation;
  return columnsOf({}, ledger, {}).head();
}

/// Returns the number of row times up to `time`.
double rowsBy(double time, double every) { return std::floor(time / every * (1 + 1e-12)); }

}  // namespace

std::string ledgerLogPath(const std::string& out) { return out + "/ledger.csv"; }

void beginLedgerLog(const std::string& out, const Modules& modules) {
  replaceTextFile(ledgerLogPath(out), head(modules));
}

void truncateLedgerLog(const std::string& out, const Modules& modules, std::int64_t step) {
  truncateStepLog(ledgerLogPath(out), head(modules), step);
}

bool ledgerRowDue(const Scene& scene, const Clock& clock, double before) {
  const double every = scene.output.ledgerEvery;
  if (frameDue(clock) || clock.time >= clock.end) return true;
  return every > 0 && rowsBy(clock.time, every) > rowsBy(before, every);
}

void writeLedgerRow(Run& r) {
  if (!r.writes() && !r.history) return;
  r.tools.times.start();
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  const StoredParts parts = storedParts(r.world, r.tools, r.all);
  const Columns columns = columnsOf(r.world.clock, ledger, parts);
  if (r.history) columns.addTo(*r.history, r.world.clock.step);
  onDisk(r, [&] {
    std::ofstream file(ledgerLogPath(r.options.out), std::ios::app);
    file << columns.row();
    file.close();
    if (!file) throw IoError(ledgerLogPath(r.options.out), "cannot be written");
  });
  r.tools.times.lap(StepPhase::Other);
}

}  // namespace thaw
