// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/activate_fields.hpp"

#include <algorithm>

#include "core/heat/conduction_correction.hpp"
#include "core/scene/tension_form.hpp"
#include "core/simulation/body_types/redistribute_body_types.hpp"
#include "core/simulation/setup/initial_fill.hpp"
#include "core/simulation/setup/prepare_surface.hpp"
#include "core/terms/extensions.hpp"

namespace thaw {

namespace {

void turnOn(Continuum& p, bool needed, std::initializer_list<AnyColumn*> columns) {
  if (needed)
    for (AnyColumn* c : columns) p.activate(*c);
}

bool anyFriction(const Walls& walls) {
  return std::any_of(walls.list.begin(), walls.list.end(),
                     [](const Wall& w) { return w.properties.friction > 0; });
}

void activateFluid(Continuum& p, const Modules& m) {
  turnOn(p, m.fluid, {&p.relativeDensity});
  turnOn(p, m.implicitViscosity, {&p.viscousAcceleration, &p.viscousSearch});
  turnOn(p, m.viscosityCorrection, {&p.viscosityCorrection});
  turnOn(p, m.flowLaw, {&p.apparentViscosity});
  turnOn(p, m.continuity, {&p.compression});
  turnOn(p, m.bulkDamping || ((m.phaseDensity || m.evaporation) && m.continuity), {&p.compressionRate});
  turnOn(p, m.corrected, {&p.midCorrection, &p.correction});
  turnOn(p, (m.continuity || m.melting) && m.substeps, {&p.stepMeanVelocity});
  turnOn(p, m.xsph || m.shifting, {&p.shiftingVelocity});
  turnOn(p, m.shifting && !m.continuity, {&p.concentrationGradient});
  turnOn(p, m.shifting && m.continuity, {&p.atSurface});
  turnOn(p, m.shifting && m.continuity && m.solid, {&p.relief});
  turnOn(p, m.incompressible,
         {&p.densityPressure, &p.divergencePressure, &p.pressureImpulse, &p.drag, &p.trialPressure,
          &p.trialVelocity, &p.correction});
  turnOn(p, m.surfaceEnergy,
         {&p.surfaceGradient, &p.surfaceColour, &p.surfaceEnergyByGradient, &p.surfaceEnergyByColour});
  turnOn(p, m.tensionTable, {&p.surfaceTension});
  turnOn(p, m.buoyancy, {&p.buoyancy});
  turnOn(p, m.phaseDensity, {&p.restDensity});
}

void activateHeat(Continuum& p, const Scene& s, const Modules& m) {
  turnOn(p, m.heat, {&p.enthalpy, &p.temperature, &p.heatFlow});
  turnOn(p, correctsConduction(s, m), {&p.conductionCorrection});
  turnOn(p, m.lamps, {&p.absorbed});
  turnOn(p, m.contactConductance, {&p.contactNormal});
  turnOn(p, m.evaporation, {&p.freeSurfaceIndicator, &p.volumeGradient, &p.vapour, &p.vapourEnergy});
  turnOn(p, m.mushDrag, {&p.mushRate, &p.solidVelocity});
  turnOn(p, m.melting, {&p.liquid, &p.softening});
  turnOn(p, m.surfaceHeat, {&p.exposedArea});
}

void activatePieceFields(const Modules& m, Continuum& p, Pieces& pieces) {
  turnOn(p, true, {&p.piece, &p.bodyPosition, &p.pieceRow, &p.setLabel});
  activatePieces(pieces);
  turnOn(p, m.rigidify, {&p.restTime, &p.constraintForce});
  turnOn(p, !m.rigidify, {&p.faceNormal, &p.faceOffset, &p.faceRadius, &p.contactPartner, &p.contactImpulse});
  turnOn(p, m.rollingFriction, {&p.rollingImpulse});
  turnOn(p, !m.rigidify && m.surface, {&p.exposed});
  turnOn(p, m.pieceWelding, {&p.touchTime});
}

}  // namespace

void activateFields(World& w, const TermWork& terms, ElasticWork& elastic) {
  Continuum& p = w.particles;
  const Modules& m = w.modules;
  turnOn(p, true,
         {&p.id, &p.position, &p.velocity, &p.acceleration, &p.mass, &p.material, &p.body, &p.dissipated,
          &p.cell, &p.phase, &p.dissipation, &p.interaction});
  turnOn(p, !terms.outside.empty(), {&p.outsideForce});
  const bool curvature = actsByCurvature(w.scene.numerics, m), pairTension = m.tension && !curvature;
  if (curvature) declareTensionForce(p);
  for (const auto& added : p.added) p.activate(*added);
  activateFluid(p, m);
  turnOn(p, curvature, {&p.surfaceGradient, &p.surfaceColour, &p.setLabel});
  turnOn(p, m.shifting && m.continuity && (pairTension || !terms.pairForces.empty()), {&p.positionForce});
  activateHeat(p, w.scene, m);
  turnOn(p, m.surface, {&p.surfacePosition, &p.component});
  turnOn(p, m.surface && m.solid, {&p.surfaceStartPosition});
  turnOn(p, m.surface && w.scene.surface.enforceVolume > 0, {&p.surfaceVolumeRatio});
  turnOn(p, m.surface && anyInitialFill(w.scene), {&p.initialFill});
  turnOn(p, m.solid, {&p.solidIndex});
  turnOn(p, m.substeps, {&p.fastAcceleration});
  turnOn(p, m.freezing, {&p.contactOffset});
  turnOn(p, m.elastic && anyFriction(w.walls), {&p.wallShear});
  turnOn(p, m.elastic && !w.walls.list.empty(), {&p.contactDepth, &p.wallOffset});
  turnOn(p, m.bodyContact, {&p.contactDepth, &p.contactRest, &p.contactShear, &p.bodyContact});
  if (m.rigid) activatePieceFields(m, p, w.pieces);
  turnOn(p, m.sleep, {&p.restTime, &p.sleep, &p.constraintForce});
  if (m.sleep)  // values of skipped rows persist and move with the rows
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.relativeDensity, &p.freeSurfaceIndicator,
                                                          &p.exposedArea, &p.contactNormal})
      c->keep = Keep::Local;
  bool clamped = m.emitters;
  for (const Body& b : w.scene.bodies) clamped = clamped || !b.clamp.empty();
  turnOn(p, clamped, {&p.clamped});
  p.nextCell.shareWith(p.dissipation);  // nextCell is valid from the drift to the sort; afterwards
                                        // dissipation is summed until the kick
  // Contacts with sheets and oriented bodies read the last acceleration during force sums. For clamped and
  // sleeping particles, the acceleration does not follow from the force.
  if (clamped || m.sheet || m.orientedContact || m.sleep) turnOn(p, true, {&p.force});
  else p.force.shareWith(p.acceleration);
  activateBodyTypes(w);
  bool faces = false;
  for (const SheetPlan& s : w.sheets.plans) faces = faces || s.byFaces;
  turnOn(p, faces, {&p.sheetFace, &p.sheetNormalForce, &p.sheetContactData, &p.sheetFriction});
  if (m.surface) activateSurfaceFields(w.surface, m, !w.walls.list.empty());
  if (p.initialFill.active) w.surface.particles.activate(w.surface.particles.fill);
  if (m.solid) activateSolidFields(p, w.solids, w.bonds, elastic, {w.scene, m, w.grid});
}

}  // namespace thaw
