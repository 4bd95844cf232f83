// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/curvature_force.hpp"
#include "core/flow/curvature/tension_interval.hpp"
#include "core/fluid/laws/surface_energy.hpp"
#include "core/scene/tension_form.hpp"
#include "core/simulation/ledger/energy_left.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {

StepModule surfaceEnergy() {
  return {
      "surface tension as an energy",
      [](const World& w, const TermWork&) { return w.modules.surfaceEnergy; },
      {{ModulePhase::DensitySums,
        [](StepContext& c) { c.t.sums.kernels->surfaceColours(pairSumsOf(c.w, c.t.sums), c.rows.groups); }},
       {ModulePhase::Density,
        [](StepContext& c) { findSurfaceEnergy(c.walls, c.t.surface, c.t.walls.contacts); }}},
      [](Continuum& p) {
        return GhostColumns{{}, {&p.surfaceEnergyByGradient, &p.surfaceEnergyByColour}};
      },
      [](World& w, StepTools& t) { t.surface = surfaceMeasure(w.scene.numerics, w.scene.spacing); }};
}

StepModule tensionByTemperature() {
  return {"tension by temperature",
          [](const World& w, const TermWork&) { return w.modules.tensionTable; },
          {{ModulePhase::PhaseChange, [](StepContext& c) {
              recordTensionChange({wallView(c.w), c.t.surface}, c.t.walls.contacts);
            }}}};
}

StepModule tensionByCurvature() {
  StepModule module{
      "surface tension by curvature",
      [](const World& w, const TermWork&) { return actsByCurvature(w.scene.numerics, w.modules); },
      {{ModulePhase::FirstKick,
        [](StepContext& c) { recordCurvatureKick(wallView(c.w), HalfKick::First, c.dt); }},
       {ModulePhase::DensitySums,
        [](StepContext& c) {
          if (isTensionDue(c.t.limits.tensionInterval, c.w.clock, c.dt))
            c.t.sums.kernels->surfaceColours(pairSumsOf(c.w, c.t.sums), c.rows.groups);
        }},
       {ModulePhase::ContinuumForce,
        [](StepContext& c) {
          if (isTensionDue(c.t.limits.tensionInterval, c.w.clock, c.dt))
            addCurvatureForce(
                {wallView(c.w), c.w.neighbours, c.t.walls.contacts, c.halos.cells, c.halos.all});
          else reuseCurvatureForce(c.w.particles);
          c.t.times.lap(StepPhase::Forces);
        }},
       {ModulePhase::SecondKick,
        [](StepContext& c) { recordCurvatureKick(wallView(c.w), HalfKick::Second, c.dt); }}}};
  module.prepare = [](World& w, StepTools& t) { t.limits.tensionInterval = tensionInterval(w.scene); };
  return module;
}

StepModule energyOfLeaving() {
  return {
      "energy left by particles that leave",
      [](const World& w, const TermWork& terms) { return w.modules.tension || !terms.pairForces.empty(); },
      {{ModulePhase::Density, [](StepContext& c) { recordEnergyLeft(c.w, c.t); }}}};
}

}  // namespace thaw
