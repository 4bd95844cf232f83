// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/rigid/breaking/break_pieces.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/motion.hpp"
#include "core/rigid/update_pieces.hpp"
#include "core/rigid/welding/weld_pieces.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {

/// Motion of rigid pieces.
StepModule rigidPieces() {
  return {"rigid pieces",
          [](const World& w, const TermWork&) { return w.modules.rigid; },
          {{ModulePhase::Migrated,
            [](StepContext& c) {
              const Continuum& p = c.w.particles;
              for (const std::uint32_t i : c.t.redistribution.migration.departed)
                if (p.piece[i] != notRigid) c.t.rigid.departed.push_back(p.piece[i]);
            }},
           {ModulePhase::Drift,
            [](StepContext& c) {
              driftPieces(rigidView(c.w, c.t.rigid), c.dt);
              c.t.redistribution.mayLeave = true;
            }},
           {ModulePhase::Density,
            [](StepContext& c) {
              const RigidView view = rigidView(c.w, c.t.rigid);
              if (c.t.rigid.atStart) updatePieces(view, c.halos, true);
              c.t.rigid.atStart = false;
              linkPieces(view, c.halos, PieceUsers::AndGhosts);
            }},
           {ModulePhase::AllForces,
            [](StepContext& c) { sumPieceForces(rigidView(c.w, c.t.rigid), c.halos.all); }},
           {ModulePhase::Kicked, [](StepContext& c) { kickPieces(rigidView(c.w, c.t.rigid), c.dt); }}},
          [](Continuum& p) {
            return GhostColumns{{&p.piece, &p.faceNormal, &p.faceOffset, &p.faceRadius}, {}};
          }};
}

/// Pieces of rigid materials. Pieces change when particles melt, freeze or leave. Their contacts are
/// impulses.
StepModule rigidBodies() {
  return {"rigid materials",
          [](const World& w, const TermWork&) { return w.modules.rigid && !w.modules.rigidify; },
          {{ModulePhase::PhaseChange,
            [](StepContext& c) {
              if (c.t.rigid.changedHere) c.t.phaseChange.meltedAnywhere = true;
            }},
           {ModulePhase::EndOfStep, [](StepContext& c) {
              if (!c.finite) return;
              const RigidView view = rigidView(c.w, c.t.rigid);
              if (c.t.phaseChange.meltedAnywhere || c.t.phaseChange.frozeAnywhere) {
                updatePieces(view, c.halos, false);
                c.t.rigid.changedHere = false;
                linkPieces(view, c.halos, PieceUsers::AndGhosts);
              }
              if (c.w.modules.pieceWelding) weldPieces(view, c.halos);
              // At the end of the scene the next step is unlimited.
              const double planned = nextStep(c.w.clock);
              touchAndBreak(view, c.halos, std::isfinite(planned) ? planned : c.w.clock.stepDt);
              c.t.times.lap(StepPhase::Contact);
            }}}};
}

}  // namespace thaw
