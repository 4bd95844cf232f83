// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/heat/heat.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/terms/extensions.hpp"

namespace thaw {
namespace {

/// Appends the particles of layers that leave in (before, after] whose cell this rank owns.
std::size_t emit(World& w, const CellHalo& halo, const ParticleSources& sources, double before,
                 double after) {
  Continuum& p = w.particles;
  const std::size_t had = p.owned;
  for (std::size_t e = 0; e < w.scene.emitters.size(); e++) {
    const Emitter& emitter = w.scene.emitters[e];
    const EmitterPlan& plan = sources.emitters[e];
    const Material& m = w.scene.materials[static_cast<std::size_t>(emitter.material)];
    const Vec3d direction = normalized(emitter.direction);
    const std::int64_t begin = sources.emitFirst ? 0 : layersUntil(emitter, plan, before),
                       end = layersUntil(emitter, plan, after);
    for (std::int64_t layer = begin; layer < end; layer++) {
      const double age = after - leavingTime(emitter, plan, layer);  // negative in the nozzle
      for (std::size_t k = 0; k < plan.layer.size(); k++) {
        const Vec3d velocity = plan.velocity.empty() ? direction * emitter.speed : plan.velocity[k];
        const Vec3d x = plan.velocity.empty() ? plan.layer[k] + direction * (emitter.speed * age)
                                              : plan.layer[k] + velocity * age;
        const double temperature = plan.temperature.empty() ? emitter.temperature : plan.temperature[k];
        const std::uint64_t cell = cellKey(cellOf(w.grid, x));
        if (!halo.owns(cell)) continue;
        const std::size_t i = p.owned;
        p.resize(i + 1, 0);
        const std::uint64_t source = w.scene.bodies.size() + e;
        p.id[i] = particleId(source, static_cast<std::uint64_t>(layer) * plan.layer.size() + k);
        p.clamped[i] = age < 0 ? driven : 0;
        p.position[i] = x;
        p.velocity[i] = velocity;
        p.mass[i] = plan.particleMass;
        p.material[i] = static_cast<std::uint16_t>(emitter.material);
        p.body[i] = static_cast<std::uint16_t>(source);
        if (p.enthalpy.active) p.enthalpy[i] = ledgerEnthalpy(w.scene.numerics.heat, m, temperature, 1);
        if (p.temperature.active) p.temperature[i] = temperature;
        p.cell[i] = p.nextCell[i] = cell;
        if (p.solidIndex.active) p.solidIndex[i] = noSolid;
        w.ledger.entered.potential.add(cohesionAtEntry(plan, layer, k));
        w.counters.emitted++;
      }
    }
  }
  startFields(p, had, p.owned);
  if (AddedColumn* newborn = newbornOf(p)) {
    std::fill(newborn->row(0), newborn->row(had), 0.0);
    std::fill(newborn->row(had), newborn->row(p.owned), 1.0);
  }
  setPhase(w.scene, w.modules, p, had, p.owned);
  return p.owned - had;
}

/// Records mass, momentum and energy of emitted particles, the last owned rows, as entered.
void recordEmitted(World& w, PhaseChangeWork& phaseChange, std::size_t emitted) {
  const Continuum& p = w.particles;
  std::vector<std::uint32_t> fresh;
  for (std::size_t i = p.owned - emitted; i < p.owned; i++) {
    fresh.push_back(static_cast<std::uint32_t>(i));
    if (p.phase[i] == Solid) phaseChange.here = true;  // a particle emitted as solid needs a row in Solids
  }
  addToBalance(w, fresh, w.ledger.entered);
}

}  // namespace

StepModule emitters() {
  return {"emitters",
          [](const World& w, const TermWork&) { return w.modules.emitters; },
          {{ModulePhase::Emission, [](StepContext& c) {
              const double start = c.w.clock.time;  // the clock still shows the beginning of the step
              releaseDriven(c.w.scene, c.t.sources.emitters, start + c.dt, c.w.particles);
              c.t.redistribution.emitted = emit(c.w, c.halos.cells, c.t.sources, start, start + c.dt);
              c.t.sources.emitFirst = false;
              recordEmitted(c.w, c.t.phaseChange, c.t.redistribution.emitted);
            }}}};
}

}  // namespace thaw
