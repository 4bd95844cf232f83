// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/flow/incompressible/pressure_solver.hpp"
#include "core/halo/exchange.hpp"
#include "core/kernels/lattice.hpp"
#include "core/scene/full_box.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/joint_of_pieces.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

/// Runs the pressure solver. dt (s): the step that ends now. Collective.
void solvePressure(World& w, Halos halos, StepTools& t, double dt) {
  std::optional<PieceJoint> joint = jointOfPieces(w, halos, t.rigid);
  findPressure({w.scene,
                w.modules,
                w.grid,
                w.particles,
                w.neighbours,
                w.walls,
                w.clock,
                w.ledger,
                w.counters,
                w.pressureIterations,
                halos,
                pairSumsOf(w, t.sums),
                *t.sums.kernels,
                t.liquids,
                t.sums.records,
                t.walls.tables,
                t.sums.scales.inverseLatticeSum,
                t.walls.contacts,
                t.pressure,
                t.times,
                joint ? &*joint : nullptr},
               dt);
}

/// Sets the constants of the pressure solver.
void planPressure(const Scene& s, const std::vector<LiquidMaterial>& liquids, double inverseLatticeSum,
                  PressureWork& work) {
  const Numerics& n = s.numerics;
  double sound = 0;  // proportional to the expected speed
  for (const LiquidMaterial& l : liquids) sound = std::max(sound, l.soundSpeed);
  work.targetRelativeDensity = 1 + (slidingLatticeSum(n) - latticeSum(n)) * inverseLatticeSum;
  work.closed = liquidFillsTheBox(s) || n.buoyancy == Buoyancy::Boussinesq;
  if (work.closed) work.targetRelativeDensity += flowDensityExcess;
  work.relaxation = 0.9 / largestPressureResponse(n);
  work.correctionTime = s.spacing / (sound * std::sqrt(n.maxDensityError));
}

}  // namespace

StepModule incompressiblePressure() {
  return {"incompressible liquid",
          [](const World& w, const TermWork&) { return w.modules.incompressible; },
          {{ModulePhase::FirstKick,
            [](StepContext& c) {
              addPressureImpulse(c.w.particles);  // computed at the end of the last step
            }},
           {ModulePhase::EndOfStep,
            [](StepContext& c) {
              if (!c.finite) return;
              Continuum& p = c.w.particles;
              if (c.t.phaseChange.meltedAnywhere && p.clamped.active)  // melting releases clamped particles
                refresh(c.halos.cells, p, ColumnList{&p.clamped}).wait();
              // Removes compression from the velocities and computes the next density-pressure impulse.
              solvePressure(c.w, c.halos, c.t, c.dt > 0 ? c.dt : nextStep(c.w.clock));
            }}},
          [](Continuum& p) {
            return GhostColumns{{&p.clamped}, {&p.correction}};
          },
          [](World& w, StepTools& t) {
            planPressure(w.scene, t.liquids, t.sums.scales.inverseLatticeSum, t.pressure);
          }};
}

}  // namespace thaw
