// SPDX-License-Identifier: Apache-2.0
#include "core/terms/extensions.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {
namespace {

/// Records the pair energy of the particles emitted in this step.
void recordEntry(World& w, const PairSums& sums, PairForceWork& work, const AddedColumn& newborn) {
  const Continuum& p = w.particles;
  bool any = false;
  for (std::size_t i = 0; i < p.size(); i++) any = any || newborn.row(i)[0] > 0;
  if (!any) return;
  clearPairRecords(w.scene.numerics.precision, newborn, p.size(), work);
  for (std::size_t i = 0; i < p.owned; i++) w.ledger.entered.potential.add(work.energy[i]);
  work.energy.assign(p.owned, 0);
  PairSums others = sums;
  std::vector<Vec3d> force(p.owned);
  std::vector<double> dissipation(p.owned);
  others.force = force.data(), others.dissipation = dissipation.data();
  work.force->kernels.sum(
      others, {work.records.data(), constantsOf(w.scene, w.grid.support, work), work.energy.data()},
      {0, w.neighbours.groups});
  for (std::size_t i = 0; i < p.owned; i++) w.ledger.entered.potential.add(-work.energy[i]);
}

/// Adds the forces, with their energies. Requires: ghosts, and the records of this step.
void sumPairForces(World& w, StepTools& t) {
  Continuum& p = w.particles;
  PairSums sums = pairSumsOf(w, t.sums);
  if (p.positionForce.active) sums.force = p.positionForce.data();
  const AddedColumn* newborn = newbornOf(p);
  for (PairForceWork& work : t.terms.pairForces) {
    resizePairForce(sums.precision, p.owned + t.sums.ghostRoom, work);
    packPairForce(w.scene, p, 0, p.size(), work);
    work.energy.assign(p.owned, 0);
    work.force->kernels.sum(
        sums, {work.records.data(), constantsOf(w.scene, w.grid.support, work), work.energy.data()},
        {0, w.neighbours.groups});
    for (std::size_t i = 0; i < p.owned; i++) p.interaction[i] += work.energy[i];
    for (std::size_t i = 0; w.modules.melting && i < p.owned; i++)
      t.phaseChange.energy.inPairs[i] += work.energy[i];
    if (newborn) recordEntry(w, sums, work, *newborn);
  }
  t.times.lap(StepPhase::Forces);
}

}  // namespace

StepModule extensionPairForces() {
  return {"pair forces of extensions",
          [](const World&, const TermWork& terms) { return !terms.pairForces.empty(); },
          {{ModulePhase::ContinuumForce, [](StepContext& c) { sumPairForces(c.w, c.t); }}}};
}

}  // namespace thaw
