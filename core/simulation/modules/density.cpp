// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/monitor/monitor.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule summedDensity() {
  return {"summed density",
          [](const World& w, const TermWork&) { return w.modules.fluid && !w.modules.continuity; },
          {{ModulePhase::DensitySums,
            [](StepContext& c) { c.t.sums.kernels->density(pairSumsOf(c.w, c.t.sums), c.rows.groups); }},
           {ModulePhase::Density,
            [](StepContext& c) {
              addWallRelativeDensity(c.walls, c.t.sums.scales.inverseLatticeSum, c.t.walls.contacts);
              c.t.times.lap(StepPhase::Walls);
            }}},
          [](Continuum& p) {
            return GhostColumns{{}, {&p.relativeDensity, &p.correction}};
          }};
}

namespace {

/// Advances the carried densities of liquids over the step.
void sumCarriedDensities(StepContext& c) {
  const CarryContext context = carryContext(c.w, c.t, c.dt);
  CarryStep carry = carryStepOf(context);
  PairSums sums = pairSumsOf(c.w, c.t.sums);
  sums.carry = &carry;
  sums.positionVolume = c.t.sums.records.middle.data();
  c.t.sums.kernels->density(sums, c.rows.groups);
}

}  // namespace

StepModule carriedDensity() {
  return {"density by continuity",
          [](const World& w, const TermWork&) { return w.modules.continuity; },
          {{ModulePhase::BeforeDensity, [](StepContext& c) { beginCarry(carryContext(c.w, c.t, c.dt)); }},
           {ModulePhase::DensitySums, [](StepContext& c) { sumCarriedDensities(c); }},
           {ModulePhase::Density, [](StepContext& c) { finishCarry(carryContext(c.w, c.t, c.dt)); }},
           {ModulePhase::Limits,
            [](StepContext& c) {
              // Neighbourhoods that tear are stiffer than a lattice, and would oscillate from step to step.
              const double change = c.t.carry.largestChange, dt = c.w.clock.stepDt;
              if (change > 0 && dt > 0) c.reduction.lower(Limit::Density, dt * densityChangePerStep / change);
            }}},
          [](Continuum& p) {
            return GhostColumns{{&p.compression, &p.shiftingVelocity, &p.atSurface, &p.clamped},
                                {&p.relativeDensity, &p.correction, &p.relief}};
          }};
}

StepModule shiftingInside() {
  return {"shifting with summed densities",
          [](const World& w, const TermWork&) { return w.modules.shifting && !w.modules.continuity; },
          {{ModulePhase::Density, [](StepContext& c) { shiftInside(carryContext(c.w, c.t, c.dt)); }}}};
}

StepModule forcesAgainstShifting() {
  return {"forces against which shifting works",
          [](const World& w, const TermWork&) { return w.particles.positionForce.active; },
          {{ModulePhase::ContinuumForce, [](StepContext& c) { addPositionForces(c.w.particles); }}}};
}

StepModule densityMonitor() {
  return {"largest density of liquids",
          [](const World& w, const TermWork&) { return w.modules.fluid; },
          {{ModulePhase::Limits,
            [](StepContext& c) { c.reduction.relativeDensity = largestRelativeDensity(c.w.particles); }}}};
}

}  // namespace thaw
