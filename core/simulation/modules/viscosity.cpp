// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "core/flow/implicit_viscosity/implicit_viscosity.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/joint_of_pieces.hpp"

namespace thaw {
namespace {

/// Computes the viscous forces of the implicit solver. Requires: all other forces.
void solveViscosity(World& w, Halos halos, StepTools& t, const WallContext& walls) {
  std::optional<PieceJoint> joint = jointOfPieces(w, halos, t.rigid);
  addImplicitViscosity({w.neighbours, *t.sums.kernels, t.sums.ghostRoom, t.walls.contacts, t.viscous, t.times,
                        joint ? &*joint : nullptr},
                       halos, pairSumsOf(w, t.sums), walls);
}

/// Returns true in steps that update Continuum::viscosityCorrection.
bool viscosityCorrectionDue(const Modules& modules, const Clock& clock) {
  constexpr std::int64_t everySteps = 8;  // in an explicit step the flow moves by much less than a spacing
  return modules.viscosityCorrection && (modules.implicitViscosity || clock.step % everySteps == 0);
}

/// Computes WallWork::shares of no-slip walls for all owned rows. support: m.
void findWallShares(const Walls& walls, double support, std::size_t owned, WallWork& work) {
  work.shares.assign(owned, {});
  for (const WallContact& c : work.contacts.list) {
    if (walls.list[c.wall].properties.slip) continue;
    const WallIntegrals at = work.tables(c.distance / support);
    work.shares[c.row].density += static_cast<float>(at.space * c.share);
    work.shares[c.row].shear += static_cast<float>(at.shear * c.share);
  }
}

/// Updates Continuum::viscosityCorrection for the next step. Requires: the records of this step.
void correctViscosity(World& w, const PairSumWork& work, WallWork& walls) {
  PairSums s = pairSumsOf(w, work);
  if (!walls.contacts.list.empty()) {
    findWallShares(w.walls, w.grid.support, w.particles.owned, walls);
    s.viscosityWalls = walls.shares.data();
  }
  s.viscosityCorrection = w.particles.viscosityCorrection.data();
  s.largestViscosityFactor = w.modules.implicitViscosity ? 2 : 1.25;
  work.kernels->viscosityCorrection(s, {0, w.neighbours.groups});
}

}  // namespace

StepModule implicitViscosity() {
  return {"implicit viscosity",
          [](const World& w, const TermWork&) { return w.modules.implicitViscosity; },
          {{ModulePhase::AllForces, [](StepContext& c) { solveViscosity(c.w, c.halos, c.t, c.walls); }}}};
}

StepModule viscosityCorrection() {
  return {"corrected viscosity",
          [](const World& w, const TermWork&) { return w.modules.viscosityCorrection; },
          {{ModulePhase::AllForces,
            [](StepContext& c) {
              // Used in the next step.
              if (viscosityCorrectionDue(c.w.modules, c.w.clock)) correctViscosity(c.w, c.t.sums, c.t.walls);
            }}},
          [](Continuum& p) {
            return GhostColumns{{&p.viscosityCorrection}, {}};
          }};
}

}  // namespace thaw
