// SPDX-License-Identifier: Apache-2.0
// Body forces and sources of heat of the library (core/terms/terms.hpp), and loads of programs.
#include <algorithm>

#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {
namespace {

/// Returns the load of this step. Its arrays are the fields of the particles.
OutsideLoad loadOf(StepContext& c) {
  Continuum& p = c.w.particles;
  return {p,
          c.time,
          p.force.data(),
          p.heatFlow.active ? p.heatFlow.data() : nullptr,
          c.dt,
          heatView(c.w),
          c.w.walls,
          c.halos.all,
          c.walls.steady};
}

void addTerms(StepContext& c, LoadStage stage) {
  for (const ActiveTerm& term : c.t.terms.active)
    if (term.part->stage == stage) term.add(loadOf(c));
}

void recordTerms(StepContext& c, HalfKick kick) {
  for (const ActiveTerm& term : c.t.terms.active)
    if (term.part->recordKick) term.part->recordKick(loadOf(c), kick);
}

bool hasTerms(const TermWork& terms, LoadStage stage) {
  return std::any_of(terms.active.begin(), terms.active.end(),
                     [&](const ActiveTerm& term) { return term.part->stage == stage; });
}

Limit limitNamed(std::string_view name) {
  return static_cast<Limit>(std::find(limitNames.begin(), limitNames.end(), name) - limitNames.begin());
}

void recordLoads(StepContext& c, HalfKick kick) {
  Continuum& p = c.w.particles;
  if (p.outsideForce.active) recordOutsideKick(p, kick, c.w.scene.domain.gravity, c.dt, c.w.ledger);
}

}  // namespace

/// This module is always on. A program may add loads during a run (Simulation::addForce), and a checkpoint
/// may contain loads.
StepModule outsideLoads() {
  return {"loads from outside",
          [](const World&, const TermWork&) { return true; },
          {{ModulePhase::FirstKick, [](StepContext& c) { recordLoads(c, HalfKick::First); }},
           {ModulePhase::AllForces,
            [](StepContext& c) {
              if (c.w.particles.outsideForce.active) addOutsideLoads(c.t.terms.outside, loadOf(c));
            }},
           {ModulePhase::SecondKick, [](StepContext& c) { recordLoads(c, HalfKick::Second); }}}};
}

StepModule bodyForces() {
  return {"body forces",
          [](const World&, const TermWork& terms) { return hasTerms(terms, LoadStage::Forces); },
          {{ModulePhase::FirstKick, [](StepContext& c) { recordTerms(c, HalfKick::First); }},
           {ModulePhase::ContinuumForce, [](StepContext& c) { addTerms(c, LoadStage::Forces); }},
           {ModulePhase::SecondKick, [](StepContext& c) { recordTerms(c, HalfKick::Second); }}}};
}

StepModule heatExchange() {
  return {"heat exchange",
          [](const World&, const TermWork& terms) { return hasTerms(terms, LoadStage::Exchange); },
          {{ModulePhase::AllForces, [](StepContext& c) { addTerms(c, LoadStage::Exchange); }}}};
}

StepModule heatSources() {
  return {"heat sources",
          [](const World&, const TermWork& terms) { return hasTerms(terms, LoadStage::Sources); },
          {{ModulePhase::AllForces, [](StepContext& c) {
              Continuum& p = c.w.particles;
              if (p.absorbed.active) std::fill_n(p.absorbed.data(), p.owned, 0.0f);
              addTerms(c, LoadStage::Sources);
            }}}};
}

StepModule limitsOfTerms() {
  return {"limits of terms",
          [](const World&, const TermWork& terms) {
            return std::any_of(terms.active.begin(), terms.active.end(),
                               [](const ActiveTerm& term) { return term.part->stepLimit != nullptr; });
          },
          {{ModulePhase::Limits, [](StepContext& c) {
              for (const ActiveTerm& term : c.t.terms.active)
                if (term.part->stepLimit)
                  c.reduction.lower(limitNamed(term.part->limits.front()),
                                    term.part->stepLimit(c.w.scene, c.w.clock.time));
            }}}};
}

}  // namespace thaw
