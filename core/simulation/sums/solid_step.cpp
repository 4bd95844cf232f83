// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sums/solid_step.hpp"

#include <algorithm>
#include <utility>

#include "core/contact/body_contact.hpp"
#include "core/contact/solid_contact.hpp"
#include "core/halo/bonded_rows.hpp"
#include "core/solid/bonds/bond_forming.hpp"
#include "core/solid/elasticity/active_solids.hpp"
#include "core/solid/elasticity/rereference.hpp"
#include "core/solid/elasticity/solid_state.hpp"
#include "core/solid/fracture.hpp"
#include "core/solid/melting.hpp"

namespace thaw {

ElasticStep elasticStep(const ElasticWork& elastic, double dt) {
  return {dt, elastic.energyInSteps, elastic.deformationInSteps};
}

namespace {

/// Chooses the solids whose energy may change, if bonds or solids changed on this rank.
void chooseActive(const Continuum& p, Solids& solids, const Bonds& bonds, BondHalo& halo,
                  ElasticWork& elastic) {
  SolidPieces pieces;
  pieces.resize(solids.owned, solids.ghosts);
  for (std::size_t s = 0; s < solids.owned; s++) pieces.piece[s] = p.piece[solids.particle[s]];
  refresh(halo, solids, ColumnList{&pieces.piece}).wait();
  if (!activeSolidsKnown(elastic, solids)) chooseActiveSolids(elastic, solids, bonds, pieces);
}

void deformAll(World& w, Halos& halos, StepTools& t, const ElasticStep& step, Exchange ends) {
  if (w.modules.sleep) chooseAwakeGroups(w.particles, w.solids, t.solid.elastic, t.sleep);
  if (w.modules.rigidify) {
    ends.wait();  // a halo can have only one refresh in flight
    chooseActive(w.particles, w.solids, w.bonds, halos.bonds, t.solid.elastic);
  }
  ElasticResult r = computeDeformationAndStress(t.solid.elastic, w.solids, w.bonds, step, SolidPart::Inner);
  t.times.lap(StepPhase::Elastic);
  ends.wait();
  t.times.lap(StepPhase::Bonds);
  r += computeDeformationAndStress(t.solid.elastic, w.solids, w.bonds, step, SolidPart::Boundary);
  w.counters.inverted += r.inverted;
  w.counters.softenedParticles += r.softenedParticles;
  t.solid.maxStretch2 = r.maxStretch2;
  // Includes sleeping groups; empty without sleep.
  for (const double stretch2 : t.solid.elastic.groupStretch2)
    t.solid.maxStretch2 = std::max(t.solid.maxStretch2, stretch2);
}

BondForming bondForming(const Scene& scene, const Modules& modules, const SolidWork& work) {
  BondForming forming;
  forming.rule = work.bondsAtStart ? BondRule::Start
                 : modules.welding ? BondRule::Welding
                                   : BondRule::Freezing;
  forming.support = work.elastic.support;
  forming.touch = contactDistance * scene.spacing;  // distance of contact repulsion
  forming.touchBodies = weldDistance * scene.spacing;
  forming.selfWeld = scene.numerics.selfContact;
  forming.periods = work.elastic.periods;
  forming.materials = &scene.materials;
  return forming;
}

/// Updates the data derived from bonds after a bond update with changes on any rank.
void updateBondData(World& w, BondHalo& halo, SolidWork& work, SleepWork& sleep) {
  fillNewSolids(w.particles, w.solids, work.elastic, work.bondsAtStart);
  if (w.modules.sleep) forgetChangedSolids(w.solids, sleep);
  forgetActiveSolids(work.elastic);
  refresh(halo, w.solids, remoteColumnsAfterRebuild(w.solids)).wait();
  w.counters.singularNeighbourhoods = refreshReference(work.elastic, w.solids, w.bonds, false);
}

/// Records the energy of the particles that requested bonds, times `sign`. Call it with 1 before the bonds
/// exist and with -1 afterwards, at the same positions.
void recordEnergyJump(World& w, SolidWork& work, double sign) {
  if (sign > 0) {
    work.rebonded.clear();
    for (const BondRequest& q : work.requests) {
      const std::uint32_t row = w.solids.particle[q.solidIndex];  // requests of a particle are contiguous
      if (work.rebonded.empty() || work.rebonded.back() != row) work.rebonded.push_back(row);
    }
  }
  for (const std::uint32_t row : work.rebonded)
    w.ledger.phaseJump.add(sign * solidEnergy(work.elastic, w.solids, w.bonds, w.particles.solidIndex[row]));
}

/// Returns the number of solid ghosts, an upper bound of remote rows at the start.
std::size_t solidGhosts(const Continuum& p) {
  std::size_t n = 0;
  for (std::size_t i = p.owned; i < p.size(); i++) n += p.phase[i] == Solid;
  return n;
}

/// Returns the number of parts in which all ranks make the initial bonds. The requests of one part fit into a
/// cache.
std::size_t partsOfStart(const NeighbourLists& lists, Reducer& all) {
  double listed = 0;
  for (const std::uint16_t n : lists.neighbours) listed += n;
  all.maximum({&listed, 1});
  constexpr double together = 1 << 18;
  return static_cast<std::size_t>(std::clamp(listed / together, 8.0, 64.0));
}

/// Makes the initial bonds in parts, since all requests at once would take many times the memory of the
/// bonds.
void bondScene(World& w, Halos& halos, SolidWork& work, SleepWork& sleep) {
  takeReferences(w.particles, w.solids);
  const BondForming forming = bondForming(w.scene, w.modules, work);
  std::vector<BondRequest> requests;
  std::vector<BondPair> pairs;
  int mostNeighbours = 0;
  for (const std::uint16_t n : w.neighbours.neighbours) mostNeighbours = std::max<int>(mostNeighbours, n);
  const std::size_t remotes = solidGhosts(w.particles);
  w.solids.reserve(w.solids.owned + remotes);
  const std::size_t parts = partsOfStart(w.neighbours, halos.all);
  const auto part = [&](std::size_t k) {
    return ListedGroups{k * w.neighbours.groups / parts, (k + 1) * w.neighbours.groups / parts};
  };
  if (!w.bonds.vectors) {  // reserves memory for the largest part, since growth would take twice the memory
    std::size_t most = 0;
    for (std::size_t k = 0; k < parts; k++) {
      std::size_t places = 0;
      for (std::size_t g = part(k).first; g < part(k).last; g++)
        places += std::size_t(lanes) * w.neighbours.count[g];
      most = std::max(most, places);
    }
    pairs.reserve(most);
  }
  for (std::size_t k = 0; k < parts; k++) {
    requests.clear();
    pairs.clear();
    if (w.bonds.vectors)
      formBonds({w.particles, w.solids, w.bonds, w.neighbours}, forming, requests, part(k));
    else pairAtStart(w.particles, w.neighbours, forming, pairs, part(k));
    halos.bonds.rebuildBonds(bondedRows(w.particles), w.solids, w.bonds,
                             {requests, false, pairs, mostNeighbours, remotes});
  }
  if (fieldsDeferred(w.bonds, work))
    for (AnyColumn* c : columnsOfSteps(w.solids, work.elastic)) w.solids.activate(*c);
  updateBondData(w, halos.bonds, work, sleep);
  work.bondsAtStart = false;
}

/// Makes the initial bonds, or bonds after freezing. Existing stress does not change, since references
/// account for F of older ends.
void requestBonds(World& w, Halos& halos, StepTools& t) {
  Continuum& p = w.particles;
  if (w.modules.rigidify) deformPassive(t.solid.elastic, w.solids, w.bonds);
  prepareBondForming(p, w.solids);
  refresh(halos.cells, p, bondFormingColumns(p)).wait();
  if (t.solid.bondsAtStart) return bondScene(w, halos, t.solid, t.sleep);
  t.solid.requests.clear();
  w.counters.welds += formBonds({p, w.solids, w.bonds, w.neighbours},
                                bondForming(w.scene, w.modules, t.solid), t.solid.requests);
  recordEnergyJump(w, t.solid, 1);
  rebuildSolidBonds(w, halos, t, {t.solid.requests, true});
}

}  // namespace

void rebuildSolidBonds(World& w, Halos halos, StepTools& t, const BondUpdate& work) {
  t.times.lap(StepPhase::Sort);
  linkSolids(bondedRows(w.particles), w.solids);
  if (halos.bonds.rebuildBonds(bondedRows(w.particles), w.solids, w.bonds, work) &&
      !fieldsDeferred(w.bonds, t.solid))
    updateBondData(w, halos.bonds, t.solid, t.sleep);
  t.times.lap(StepPhase::Bonds);
}

void findElasticEnergy(Solids& solids, const Bonds& bonds, const ElasticWork& elastic) {
  if (solids.energyKnown) return;
  const bool still = atReference(solids);
  for (std::size_t s = 0; s < solids.owned; s++) {
    const auto [gradU, energy] = still ? solidStrainAtReference(elastic, solids, bonds, s)
                                       : solidStrain(elastic, solids, bonds, s);
    solids.energy[s] = energy;
    if (!elastic.deformationInSteps) solids.deformation[s] = identity3<double>() + gradU;
  }
  solids.energyKnown = true;
}

void findElasticEnergy(const Continuum& p, Solids& solids, const Bonds& bonds, const ElasticWork& elastic,
                       std::span<const std::uint32_t> rows) {
  if (solids.energyKnown) return;
  for (const std::uint32_t i : rows)
    if (const std::uint32_t solidIndex = p.solidIndex[i]; solidIndex != noSolid)
      solids.energy[solidIndex] = solidEnergy(elastic, solids, bonds, solidIndex);
}

void melt(World& w, BondHalo& halo, ElasticWork& elastic, PhaseTimes& times) {
  if (!w.solids.melted.active) return;
  markMelted(w.particles, w.solids);
  refresh(halo, w.solids, ColumnList{&w.solids.melted}).wait();
  dropMeltedBonds(elastic, w.particles, w.solids, w.bonds, w.ledger.phaseJump);
  times.lap(StepPhase::Bonds);
}

Exchange sendPositions(const Continuum& p, Solids& solids, const Bonds& bonds, BondHalo& halo,
                       const SolidWork& work) {
  if (fieldsDeferred(bonds, work)) return {};
  copyToSolids(p, solids);
  return refresh(halo, solids, remoteColumnsBeforeDeformation(solids));
}

void deformSolids(World& w, Halos halos, StepTools& t, double dt, Exchange positions) {
  const ElasticStep now = elasticStep(t.solid.elastic, dt / w.clock.substeps);
  if (!fieldsDeferred(w.bonds, t.solid)) deformAll(w, halos, t, now, std::move(positions));
}

bool bondsForm(World& w, Reducer& all, const StepTools& t) {
  const SolidWork& work = t.solid;
  if (work.bondsAtStart || t.phaseChange.frozeAnywhere) return work.bondsAtStart || w.modules.freezing;
  if (!w.modules.welding) return false;
  double touch = touchesToWeld({w.particles, w.solids, w.bonds, w.neighbours},
                               bondForming(w.scene, w.modules, work));
  all.maximum({&touch, 1});
  return touch > 0;
}

void makeBonds(World& w, Halos halos, StepTools& t, double dt) {
  const bool start = t.solid.bondsAtStart;
  requestBonds(w, halos, t);
  t.phaseChange.frozeAnywhere = false;
  ElasticStep now = elasticStep(t.solid.elastic, dt / w.clock.substeps);
  now.dt = 0;  // plastic flow is done
  deformAll(w, halos, t, now, sendPositions(w.particles, w.solids, w.bonds, halos.bonds, t.solid));
  if (!start) recordEnergyJump(w, t.solid, -1);
}

void addElasticForces(World& w, ElasticWork& elastic, PhaseTimes& times, double dt, Exchange stress) {
  const ElasticStep now = elasticStep(elastic, dt / w.clock.substeps);
  computeElasticForces(elastic, w.solids, w.bonds, now, SolidPart::Inner);
  times.lap(StepPhase::Elastic);
  stress.wait();
  times.lap(StepPhase::Bonds);
  computeElasticForces(elastic, w.solids, w.bonds, now, SolidPart::Boundary);
  w.solids.energyKnown = now.energy;
  addSolidForces(elastic, w.solids, w.particles, dt);
  if (w.particles.fastAcceleration.active)
    for (std::size_t s = 0; s < w.solids.owned; s++) {
      const std::uint32_t i = w.solids.particle[s];
      w.particles.fastAcceleration[i] = w.solids.force[s] / w.particles.mass[i];
    }
  times.lap(StepPhase::Elastic);
}

}  // namespace thaw
