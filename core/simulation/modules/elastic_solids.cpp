// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/halo/bonded_rows.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/solid_substeps.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/solid_step.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/solid/elasticity/elastic.hpp"
#include "core/solid/elasticity/rereference.hpp"
#include "core/solid/fracture.hpp"
#include "core/solid/melting.hpp"

namespace thaw {

StepModule elasticSolids() {
  return {
      "solid",
      [](const World& w, const TermWork&) { return w.modules.solid; },
      {{ModulePhase::Migrated,
        [](StepContext& c) {
          const RedistributionWork& work = c.t.redistribution;
          if (work.moved)
            c.halos.bonds.migrate(bondedRows(c.w.particles), c.w.solids, c.w.bonds, work.migration);
        }},
       {ModulePhase::Redistributed,
        [](StepContext& c) {
          StepTools& t = c.t;
          rebuildSolidBonds(c.w, c.halos, t, {{}, t.phaseChange.here || c.leftBonds || t.solid.bondsAtStart});
        }},
       {ModulePhase::GhostsSent,
        [](StepContext& c) {
          c.solidPositions = sendPositions(c.w.particles, c.w.solids, c.w.bonds, c.halos.bonds, c.t.solid);
        }},
       {ModulePhase::Deformation,
        [](StepContext& c) {
          deformSolids(c.w, c.halos, c.t, c.dt, std::move(c.solidPositions));
          c.bondsForm = bondsForm(c.w, c.halos.all, c.t);
        }},
       {ModulePhase::NewBonds, [](StepContext& c) { makeBonds(c.w, c.halos, c.t, c.dt); }},
       {ModulePhase::Stress,
        [](StepContext& c) {
          c.t.times.lap(StepPhase::Elastic);
          c.stress = refresh(c.halos.bonds, c.w.solids, remoteColumnsBeforeForces(c.w.solids));
          c.t.times.lap(StepPhase::Bonds);
        }},
       {ModulePhase::ContinuumForce,
        [](StepContext& c) {
          addElasticForces(c.w, c.t.solid.elastic, c.t.times, c.dt, std::move(c.stress));
        }},
       {ModulePhase::PhaseChange,
        [](StepContext& c) {
          World& w = c.w;
          if (w.modules.melting)
            recordSoftening(c.t.solid.elastic, w.particles, w.solids, w.bonds, w.ledger.phaseJump);
        }},
       {ModulePhase::Limits,
        [](StepContext& c) {
          c.reduction.stretch2 = c.t.solid.maxStretch2;
          c.reduction.strainBound = largestStrainBound(c.t.solid.elastic, c.w.solids);
          // Bonds may break and references may change in any step.
          c.w.counters.singularNeighbourhoods = countSingular(c.t.solid.elastic, c.w.solids);
        }},
       {ModulePhase::CommonLimits,
        [](StepContext& c) {
          // The limit is computed from the largest values of all ranks. The minimum of the ranks' limits
          // would depend on the partition.
          const StepReduction& all = c.reduction;
          c.commonLimits[Limit::Elastic] = all.stretch2 > 0
                                               ? elasticStepLimit(c.w.scene, all.stretch2, all.strainBound)
                                               : never;
        }},
       {ModulePhase::EndOfStep,
        [](StepContext& c) {
          // Bonds are dropped here and not in the next step, so that checkpoints contain the result.
          if (c.dt > 0 && c.t.phaseChange.meltedAnywhere)
            melt(c.w, c.halos.bonds, c.t.solid.elastic, c.t.times);
        }}},
      [](Continuum& p) {
        return GhostColumns{{&p.id, &p.body}, {}};
      }};
}

StepModule fracture() {
  return {"fracture",
          [](const World& w, const TermWork&) { return w.modules.fracture; },
          {{ModulePhase::Stress, [](StepContext& c) {
              const ElasticStep now = elasticStep(c.t.solid.elastic, c.dt / c.w.clock.substeps);
              c.w.counters.brokenBonds += breakBonds(c.t.solid.elastic, c.w.solids, c.w.bonds, now,
                                                     c.w.ledger.phaseJump);
            }}}};
}

StepModule newReferences() {
  return {"new references after plastic flow",
          [](const World& w, const TermWork&) { return w.modules.plastic; },
          {{ModulePhase::Stress, [](StepContext& c) {
              const ElasticStep now = elasticStep(c.t.solid.elastic, c.dt / c.w.clock.substeps);
              c.w.counters.rereferenced += rereference(c.t.solid.elastic, c.w.solids, c.w.bonds, now,
                                                       c.w.ledger.phaseJump);
            }}}};
}

namespace {

/// Returns the longest step (s) for substeps of at most `substep` (s), under the other limits (s). A substep
/// is added only if it reduces the cost of a simulated second. The assumed cost of a substep is half of the
/// cost of the remainder of a step.
double worthwhileStep(double substep, double limit, int most) {
  constexpr double cost = 0.5;
  const double whole = std::floor(limit / substep);
  if (!(whole >= 1) || whole >= most) return most * substep;
  const double shorter = whole * substep / (1 + cost * whole), longer = limit / (1 + cost * (whole + 1));
  return longer > shorter ? (whole + 1) * substep : whole * substep;
}

/// Longest step (s) at which slow forces do not amplify elastic waves. elastic: s, limit of a step without
/// substeps. Pressure and viscosity of mush, and impulses of incompressible liquid, are as stiff as bonds.
/// They amplify the fastest waves if the step reaches half a period. At a cfl_elastic of 0.8 the step is a
/// quarter of a period.
double longestWithSlowForces(const StepContext& c, double elastic) {
  constexpr double stable = 0.8;  // cfl_elastic
  const auto isNever = [](const StepLimits& limits) {
    return std::all_of(limitsOfLiquid.begin(), limitsOfLiquid.end(),
                       [&](Limit l) { return !(limits[l] < never); });
  };
  const bool withoutLiquid = isNever(c.commonLimits) && !isNever(c.t.limits.fixed);
  if (!c.w.modules.incompressible && (!c.w.modules.melting || withoutLiquid)) return never;
  return std::max(1.0, stable / c.w.scene.numerics.cflElastic) * elastic;
}

}  // namespace

StepModule solidSubsteps() {
  return {"substeps of solids",
          [](const World& w, const TermWork&) { return w.modules.substeps; },
          {{ModulePhase::Drift,
            [](StepContext& c) {
              substepSolids(c.w, c.halos, c.t, c.dt);  // stiff solids: bonds and walls, in shorter steps
            }},
           {ModulePhase::Limits,
            [](StepContext& c) {
              c.reduction.negatedFastLimit = -fastAccelerationLimit(c.w.scene, c.w.grid, c.w.particles);
            }},
           {ModulePhase::CommonLimits,
            [](StepContext& c) {
              StepLimits& limits = c.commonLimits;
              const double longest = longestWithSlowForces(c, limits[Limit::Elastic]);
              c.longestSubstep = std::min(
                  {limits[Limit::Elastic], c.t.limits.longestContact, -c.reduction.negatedFastLimit});
              limits[Limit::Elastic] = c.w.modules.mostSubsteps * c.longestSubstep;
              if (c.w.modules.rareContact)
                limits[Limit::Elastic] = worthwhileStep(c.longestSubstep, limits[limits.smallest()],
                                                        c.w.modules.mostSubsteps);
              limits[Limit::Elastic] = std::min(limits[Limit::Elastic], longest);
            }},
           {ModulePhase::NextStep,
            [](StepContext& c) {
              chooseSubsteps(c.w.modules, c.w.clock, c.w.ledger, c.t.walls.contacts,
                             c.w.monitor.factor * c.longestSubstep);
            }}},
          [](Continuum& p) {
            return GhostColumns{{&p.stepMeanVelocity}, {}};
          },
          [](World& w, StepTools& t) {
            // Contacts then limit the substep, not the step.
            if (!w.modules.contact || w.modules.rareContact)
              std::swap(t.limits.longestContact, t.limits.fixed[Limit::Contact]);
          }};
}

}  // namespace thaw
