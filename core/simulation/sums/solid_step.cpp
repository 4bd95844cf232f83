// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sums/solid_step.hpp"

#include <algorithm>
#include <utility>

#include "core/contact/body_contact.hpp"
#include "core/contact/solid_contact.hpp"
#include "core/halo/bonded_rows.hpp"
#include "core/solid/bonds/bond_forming.hpp"
#include "core/solid/elasticity/active_slots.hpp"
#include "core/solid/elasticity/rereference.hpp"
#include "core/solid/elasticity/slot_state.hpp"
#include "core/solid/fracture.hpp"
#include "core/solid/melting.hpp"

namespace thaw {
namespace {

ElasticStep elasticStep(const StepTools& t, double dt) {
  return {dt, t.solid.elastic.energyInSteps, t.solid.elastic.deformationInSteps};
}

/// Chooses the slots whose energy may change, if bonds or slots changed on this rank.
void chooseActive(World& w, Halos& halos, StepTools& t) {
  SlotPieces pieces;
  pieces.resize(w.solids.owned, w.solids.ghosts);
  for (std::size_t s = 0; s < w.solids.owned; s++) pieces.piece[s] = w.particles.piece[w.solids.particle[s]];
  refresh(halos.bonds, w.solids, ColumnList{&pieces.piece}).wait();
  if (!activeSlotsKnown(t.solid.elastic, w.solids))
    chooseActiveSlots(t.solid.elastic, w.solids, w.bonds, pieces);
}

void deformAll(World& w, Halos& halos, StepTools& t, const ElasticStep& step, Exchange ends) {
  if (w.modules.sleep) chooseAwakeGroups(w.particles, w.solids, t.solid.elastic, t.sleep);
  if (w.modules.rigidify) {
    ends.wait();  // a halo has one refresh in flight
    chooseActive(w, halos, t);
  }
  ElasticResult r = computeDeformationAndStress(t.solid.elastic, w.solids, w.bonds, step, SolidPart::Inner);
  t.times.lap(StepPhase::Elastic);
  ends.wait();
  t.times.lap(StepPhase::Bonds);
  r += computeDeformationAndStress(t.solid.elastic, w.solids, w.bonds, step, SolidPart::Boundary);
  w.counters.inverted += r.inverted;
  w.counters.squeezed += r.squeezed;
  t.solid.maxStretch2 = r.maxStretch2;
  // Includes sleeping groups; empty without sleep.
  for (const double stretch2 : t.solid.elastic.groupStretch2)
    t.solid.maxStretch2 = std::max(t.solid.maxStretch2, stretch2);
}

BondForming bondForming(const World& w, const StepTools& t) {
  BondForming forming;
  forming.rule = t.solid.bondsAtStart ? BondRule::Start
                 : w.modules.welding  ? BondRule::Welding
                                      : BondRule::Freezing;
  forming.support = t.solid.elastic.support;
  forming.touch = contactDistance * w.scene.spacing;  // distance of contact repulsion
  forming.touchBodies = weldDistance * w.scene.spacing;
  forming.selfWeld = w.scene.numerics.selfContact;
  forming.periods = t.solid.elastic.periods;
  forming.materials = &w.scene.materials;
  return forming;
}

/// Updates data after a bond update that changed something on any rank.
void updateBondData(World& w, Halos& halos, StepTools& t) {
  fillNewSlots(w.particles, w.solids, t.solid.elastic, t.solid.bondsAtStart);
  if (w.modules.sleep) forgetChangedSlots(w.solids, t.sleep);
  forgetActiveSlots(t.solid.elastic);
  refresh(halos.bonds, w.solids, remoteColumnsAfterRebuild(w.solids)).wait();
  w.counters.singularNeighbourhoods = refreshReference(t.solid.elastic, w.solids, w.bonds, false);
}

/// Returns true if bonds form in this step on any rank. Welding is checked at the current positions, so a
/// restart needs no extra state.
bool bondsForm(World& w, Halos& halos, StepTools& t) {
  if (t.solid.bondsAtStart || t.phaseChange.frozeAnywhere) return t.solid.bondsAtStart || w.modules.freezing;
  if (!w.modules.welding) return false;
  double touch = touchesToWeld(w.particles, w.solids, w.bonds, w.neighbours, bondForming(w, t));
  halos.all.maximum({&touch, 1});
  return touch > 0;
}

/// Records the energy of the particles that requested bonds, times `sign`: 1 before they have the bonds, -1
/// after, at the same positions.
void recordEnergyJump(World& w, StepTools& t, double sign) {
  if (sign > 0) {
    t.solid.rebonded.clear();
    for (const BondRequest& q : t.solid.requests) {
      const std::uint32_t row = w.solids.particle[q.slot];  // requests of a particle are contiguous
      if (t.solid.rebonded.empty() || t.solid.rebonded.back() != row) t.solid.rebonded.push_back(row);
    }
  }
  for (const std::uint32_t row : t.solid.rebonded)
    w.ledger.phaseJump.add(sign * slotEnergy(t.solid.elastic, w.solids, w.bonds, w.particles.slot[row]));
}

/// Number of solid ghosts, an upper bound of remote rows at the start.
std::size_t solidGhosts(const Continuum& p) {
  std::size_t n = 0;
  for (std::size_t i = p.owned; i < p.size(); i++) n += p.phase[i] == Solid;
  return n;
}

/// Returns the number of parts in which all ranks make the initial bonds, such that the requests of one part
/// fit a cache.
std::size_t partsOfStart(const NeighbourLists& lists, Reducer& all) {
  double listed = 0;
  for (const std::uint16_t n : lists.neighbours) listed += n;
  all.maximum({&listed, 1});
  constexpr double together = 1 << 18;
  return static_cast<std::size_t>(std::clamp(listed / together, 8.0, 64.0));
}

/// Makes all initial bonds in parts: all requests at once would take many times the memory of the bonds.
void bondScene(World& w, Halos& halos, StepTools& t) {
  takeReferences(w.particles, w.solids);
  const BondForming forming = bondForming(w, t);
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
  if (!w.bonds.vectors) {  // for the largest part; growth would take twice the memory
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
    if (w.bonds.vectors) formBonds(w.particles, w.solids, w.bonds, w.neighbours, forming, requests, part(k));
    else pairAtStart(w.particles, w.neighbours, forming, pairs, part(k));
    halos.bonds.rebuildBonds(bondedRows(w.particles), w.solids, w.bonds,
                             {requests, false, pairs, mostNeighbours, remotes});
  }
  if (fieldsDeferred(w.bonds, t))
    for (AnyColumn* c : columnsOfSteps(w.solids, t.solid.elastic)) w.solids.activate(*c);
  updateBondData(w, halos, t);
  t.solid.bondsAtStart = false;
}

/// Makes the bonds of the start or after freezing. Existing stress does not change: F of older ends is taken
/// into account.
void makeBonds(World& w, Halos& halos, StepTools& t) {
  Continuum& p = w.particles;
  if (w.modules.rigidify) deformPassive(t.solid.elastic, w.solids, w.bonds);
  prepareBondForming(p, w.solids);
  refresh(halos.cells, p, bondFormingColumns(p)).wait();
  if (t.solid.bondsAtStart) return bondScene(w, halos, t);
  t.solid.requests.clear();
  w.counters.welds += formBonds(p, w.solids, w.bonds, w.neighbours, bondForming(w, t), t.solid.requests);
  recordEnergyJump(w, t, 1);
  rebuildSolidBonds(w, halos, t, {t.solid.requests, true});
}

}  // namespace

void rebuildSolidBonds(World& w, Halos halos, StepTools& t, const BondUpdate& work) {
  t.times.lap(StepPhase::Sort);
  linkSlots(bondedRows(w.particles), w.solids);
  if (halos.bonds.rebuildBonds(bondedRows(w.particles), w.solids, w.bonds, work) &&
      !fieldsDeferred(w.bonds, t))
    updateBondData(w, halos, t);
  t.times.lap(StepPhase::Bonds);
}

void findElasticEnergy(World& w, const StepTools& t) {
  if (w.solids.energyKnown) return;
  const bool still = atReference(w.solids);
  for (std::size_t s = 0; s < w.solids.owned; s++) {
    const auto [gradU, energy] = still ? slotStrainAtReference(t.solid.elastic, w.solids, w.bonds, s)
                                       : slotStrain(t.solid.elastic, w.solids, w.bonds, s);
    w.solids.energy[s] = energy;
    if (!t.solid.elastic.deformationInSteps) w.solids.deformation[s] = identity3<double>() + gradU;
  }
  w.solids.energyKnown = true;
}

void findElasticEnergy(World& w, const StepTools& t, std::span<const std::uint32_t> rows) {
  if (w.solids.energyKnown) return;
  for (const std::uint32_t i : rows)
    if (const std::uint32_t slot = w.particles.slot[i]; slot != noSlot)
      w.solids.energy[slot] = slotEnergy(t.solid.elastic, w.solids, w.bonds, slot);
}

void melt(World& w, Halos halos, StepTools& t) {
  if (!w.solids.melted.active) return;
  markMelted(w.particles, w.solids);
  refresh(halos.bonds, w.solids, ColumnList{&w.solids.melted}).wait();
  dropMeltedBonds(t.solid.elastic, w.particles, w.solids, w.bonds, w.ledger.phaseJump);
  t.times.lap(StepPhase::Bonds);
}

Exchange sendPositions(World& w, Halos halos, const StepTools& t) {
  if (fieldsDeferred(w.bonds, t)) return {};
  copyToSolids(w.particles, w.solids);
  return refresh(halos.bonds, w.solids, remoteColumnsBeforeDeformation(w.solids));
}

Exchange deform(World& w, Halos halos, StepTools& t, double dt, SolidExchanges sent) {
  dt /= w.clock.substeps;  // the last of them
  ElasticStep now = elasticStep(t, dt);
  if (!fieldsDeferred(w.bonds, t)) deformAll(w, halos, t, now, std::move(sent.positions));
  if (bondsForm(w, halos, t)) {
    const bool start = t.solid.bondsAtStart;
    sent.densities.wait();  // since a halo has one refresh in flight
    makeBonds(w, halos, t);
    t.phaseChange.frozeAnywhere = false;
    now.dt = 0;  // plastic flow is done
    deformAll(w, halos, t, now, sendPositions(w, halos, t));
    if (!start) recordEnergyJump(w, t, -1);
    now.dt = dt;
  }
  if (w.modules.fracture)
    w.counters.brokenBonds += breakBonds(t.solid.elastic, w.solids, w.bonds, now, w.ledger.phaseJump);
  if (w.modules.plastic)
    w.counters.rereferenced += rereference(t.solid.elastic, w.solids, w.bonds, now, w.ledger.phaseJump);
  t.times.lap(StepPhase::Elastic);
  Exchange stress = refresh(halos.bonds, w.solids, remoteColumnsBeforeForces(w.solids));
  t.times.lap(StepPhase::Bonds);
  return stress;
}

void addElasticForces(World& w, StepTools& t, double dt, Exchange stress) {
  const ElasticStep now = elasticStep(t, dt / w.clock.substeps);
  computeElasticForces(t.solid.elastic, w.solids, w.bonds, now, SolidPart::Inner);
  t.times.lap(StepPhase::Elastic);
  stress.wait();
  t.times.lap(StepPhase::Bonds);
  computeElasticForces(t.solid.elastic, w.solids, w.bonds, now, SolidPart::Boundary);
  w.solids.energyKnown = now.energy;
  addSolidForces(t.solid.elastic, w.solids, w.particles, dt);
  if (w.particles.fastAcceleration.active)
    for (std::size_t s = 0; s < w.solids.owned; s++) {
      const std::uint32_t i = w.solids.particle[s];
      w.particles.fastAcceleration[i] = w.solids.force[s] / w.particles.mass[i];
    }
  t.times.lap(StepPhase::Elastic);
}

}  // namespace thaw
