#include "core/setup/activate_fields.hpp"

#include "core/kinds/place_kinds.hpp"
#include "core/setup/fill_shares.hpp"
#include "core/surface/prepare_surface.hpp"

namespace thaw {

void activateFields(World& w, StepTools& t) {
  Continuum& p = w.particles;
  const Modules& m = w.modules;
  const auto on = [&](bool needed, std::initializer_list<AnyColumn*> columns) {
    if (needed)
      for (AnyColumn* c : columns) p.activate(*c);
  };
  on(true, {&p.id, &p.position, &p.velocity, &p.acceleration, &p.mass, &p.material, &p.body, &p.dissipated,
            &p.cell, &p.phase, &p.dissipation, &p.interaction});
  on(m.fluid, {&p.filling});
  on(m.implicitViscosity, {&p.viscousAcceleration, &p.viscousSearch});
  on(m.continuity, {&p.compression, &p.densityRate, &p.spreading});
  on(m.corrected, {&p.moment, &p.midCorrection, &p.correction, &p.flow});
  on(m.continuity && m.solid, {&p.wetting, &p.solidShare, &p.liquidNearby});
  on(m.continuity && m.substeps, {&p.travel});
  on(m.xsph || m.shifting, {&p.smoothing});
  on(m.shifting, {&p.crowding});
  on(m.shifting && m.continuity, {&p.atSurface, &p.surfaceNormal, &p.gradientSize});
  on(m.shifting && m.continuity && m.solid, {&p.solidNormal, &p.relief});
  on(m.incompressible,
     {&p.holding, &p.steadying, &p.pressureKick, &p.drag, &p.trialPressure, &p.trialVelocity});
  on(m.surfaceHeat, {&p.exposure});
  on(m.surfaceEnergy, {&p.surfaceGradient, &p.surfaceCover, &p.surfacePull, &p.surfaceDraw});
  on(m.heat, {&p.enthalpy, &p.temperature, &p.heatFlow});
  on(m.melting, {&p.liquid, &p.softening});
  on(m.surface, {&p.surfacePlace, &p.component});
  on(m.surface && m.solid, {&p.surfaceStart});
  on(m.surface && w.scene.surface.keepVolume > 0, {&p.surfaceShare});
  on(m.surface && anyBodyFills(w.scene), {&p.surfaceFill});
  on(m.solid, {&p.slot});
  on(m.substeps, {&p.fastAcceleration});
  on(m.freezing, {&p.standoff});
  on(m.sleep, {&p.calm, &p.sleep, &p.hold});
  if (m.sleep)  // values of skipped rows persist and move with their rows
    for (AnyColumn* c : {static_cast<AnyColumn*>(&p.filling), static_cast<AnyColumn*>(&p.exposure)})
      c->keep = Keep::Local;
  bool clamped = m.emitters;
  for (const Body& b : w.scene.bodies) clamped = clamped || !b.clamp.empty();
  on(clamped, {&p.clamped});
  p.nextCell.shareWith(p.dissipation);  // valid from the drift to the sort; dissipation is then summed anew
                                        // until the kick
  // Contacts with sheets and oriented bodies read the last acceleration during force sums. For clamped and
  // sleeping particles it does not follow from the force.
  if (clamped || m.sheet || m.meeting || m.sleep) on(true, {&p.force});
  else p.force.shareWith(p.acceleration);
  activateKinds(w);
  bool faces = false;
  for (const SheetPlan& s : w.sheets.plans) faces = faces || s.byFaces;
  on(faces, {&p.sheetFace, &p.sheetPush, &p.sheetNumbers, &p.sheetRubs});
  if (m.surface) activateSurfaceFields(w.surface, m, !w.walls.list.empty());
  if (p.surfaceFill.active) w.surface.particles.activate(w.surface.particles.fill);
  if (m.solid) activateSolidFields(p, w.solids, w.bonds, t.elastic, w.scene, m, w.grid);
}

}  // namespace thaw
