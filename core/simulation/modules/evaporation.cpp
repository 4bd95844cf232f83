// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <span>

#include "core/heat/evaporation.hpp"
#include "core/simulation/modules/softening.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {
namespace {

/// Adds rows to the leaving rows. rows: ascending.
void addLeaving(std::span<const std::uint32_t> rows, Continuum& p, std::vector<std::uint32_t>& leaving) {
  if (rows.empty()) return;
  for (const std::uint32_t i : rows) p.nextCell[i] = noCell;
  std::vector<std::uint32_t> all;
  std::set_union(leaving.begin(), leaving.end(), rows.begin(), rows.end(), std::back_inserter(all));
  leaving = std::move(all);
}

}  // namespace

StepModule evaporation() {
  return {"evaporation",
          [](const World& w, const TermWork&) { return w.modules.evaporation; },
          {{ModulePhase::Leaving,
            [](StepContext& c) {
              RedistributionWork& work = c.t.redistribution;
              work.vapour.clear();
              if (c.dt > 0) work.vapour = removeVapour(heatView(c.w), recordContext(c.w, c.t.liquids), c.dt);
              addLeaving(work.vapour, c.w.particles, work.leaving);
            }},
           {ModulePhase::Density,
            [](StepContext& c) {
              c.t.sums.kernels->freeSurfaceIndicator(pairSumsOf(c.w, c.t.sums), {0, c.w.neighbours.groups});
              findExposure(evaporationView(c.w, c.t));
            }},
           {ModulePhase::ContinuumForce,
            [](StepContext& c) { keepPairEnergy(c.w.particles, c.t.phaseChange.energy); }},
           {ModulePhase::AllForces,
            [](StepContext& c) {
              findVapour(evaporationView(c.w, c.t), c.walls, c.t.phaseChange.energy.ofPairs, c.dt);
            }}},
          [](Continuum& p) {
            return GhostColumns{{}, {&p.volumeGradient}};
          }};
}

}  // namespace thaw
