#include "core/solid_step.hpp"

#include "core/solid/bond_forming.hpp"
#include "core/solid/fracture.hpp"
#include "core/solid/rereference.hpp"

namespace thaw {
namespace {

void deformAll(World& w, Halos& halos, StepTools& t, const ElasticStep& step) {
  ElasticResult r = computeDeformationAndStress(t.elastic, w.solids, w.bonds, step, SolidPart::Inner);
  t.times.lap(StepPhase::Elastic);
  halos.bonds.finish(w.solids);
  t.times.lap(StepPhase::Bonds);
  r += computeDeformationAndStress(t.elastic, w.solids, w.bonds, step, SolidPart::Boundary);
  w.counters.inverted += r.inverted;
  t.maxStretch2 = r.maxStretch2;
}

/// Bonds of the start, or of what has just frozen. The stress of what was there does not change: F of older ends is taken into account.
void makeBonds(World& w, Halos& halos, StepTools& t) {
  Continuum& p = w.particles;
  prepareBondForming(p, w.solids);
  const std::vector<AnyColumn*> columns = bondFormingColumns(p);
  halos.cells.beginRefresh(p, columns);
  halos.cells.finishRefresh(p);
  BondForming forming;
  forming.rule = t.bondsAtStart ? BondRule::Start : BondRule::Freezing;
  forming.support = w.grid.support;
  forming.touch = w.scene.spacing;
  forming.periods = t.elastic.periods;
  forming.materials = &w.scene.materials;
  t.requests.clear();
  w.counters.welds += formBonds(p, w.solids, w.bonds, w.neighbours, forming, t.requests);
  relinkSolids(w, halos, t, {t.requests, true});
  t.bondsAtStart = false;
}

}  // namespace

void relinkSolids(World& w, Halos halos, StepTools& t, const Relink& work) {
  t.times.lap(StepPhase::Sort);
  linkSlots(w.particles, w.solids);
  if (halos.bonds.relink(w.particles, w.solids, w.bonds, work)) {
    fillNewSlots(w.particles, w.solids, t.elastic);
    w.counters.singularNeighbourhoods = refreshReference(t.elastic, w.solids, w.bonds, false);
    const std::vector<AnyColumn*> columns = remoteColumnsAfterRelink(w.solids);
    halos.bonds.begin(w.solids, columns);
    halos.bonds.finish(w.solids);
  }
  t.times.lap(StepPhase::Bonds);
}

void beginDeformation(World& w, Halos halos) {
  copyToSolids(w.particles, w.solids);
  const std::vector<AnyColumn*> columns = remoteColumnsBeforeDeformation(w.solids);
  halos.bonds.begin(w.solids, columns);
}

void deform(World& w, Halos halos, StepTools& t, double dt) {
  ElasticStep now{dt, true};
  deformAll(w, halos, t, now);
  if (t.bondsAtStart || (t.frozeAnywhere && w.modules.freezing)) {
    makeBonds(w, halos, t);
    t.frozeAnywhere = false;
    beginDeformation(w, halos);
    now.dt = 0;  // plastic flow is done
    deformAll(w, halos, t, now);
    now.dt = dt;
  }
  if (w.modules.fracture) w.counters.brokenBonds += breakBonds(t.elastic, w.solids, w.bonds, now, w.ledger.phaseJump);
  if (w.modules.plastic) w.counters.rereferenced += rereference(t.elastic, w.solids, w.bonds, now, w.ledger.phaseJump);
  t.times.lap(StepPhase::Elastic);
  const std::vector<AnyColumn*> columns = remoteColumnsBeforeForces(w.solids);
  halos.bonds.begin(w.solids, columns);
  t.times.lap(StepPhase::Bonds);
}

void addElasticForces(World& w, Halos halos, StepTools& t, double dt) {
  const ElasticStep now{dt, true};
  computeElasticForces(t.elastic, w.solids, w.bonds, now, SolidPart::Inner);
  t.times.lap(StepPhase::Elastic);
  halos.bonds.finish(w.solids);
  t.times.lap(StepPhase::Bonds);
  computeElasticForces(t.elastic, w.solids, w.bonds, now, SolidPart::Boundary);
  addSolidForces(w.solids, w.particles, dt);
  t.times.lap(StepPhase::Elastic);
}

}  // namespace thaw
