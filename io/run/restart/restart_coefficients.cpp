// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/restart_coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/materials/liquid_materials.hpp"
#include "core/scene/expected_speeds.hpp"
#include "io/run/restart/restart_values.hpp"

namespace thaw {
namespace {

void addBlend(CheckpointValues& record, const std::string& key, const Blend& b) {
  record[key + ".solid"] = b.solid;
  record[key + ".liquid"] = b.liquid;
}

/// Adds an event of the past or the future. A change of a past event is reported and has no effect.
void addEvent(CheckpointValues& record, const std::string& at, const OrientedEvent& e) {
  addNumbers(record, at,
             {{"kind", static_cast<double>(e.kind)},
              {"time", e.time},
              {"tool", static_cast<double>(e.tool)},
              {"radius", e.radius},
              {"other", static_cast<double>(e.otherIndex)}});
  const bool cut = e.kind == OrientedEventKind::Cut;
  if (cut && e.tool == CutTool::Plane)
    addVector(record, at + "point", e.point), addVector(record, at + "normal", e.normal);
  if (cut && e.tool == CutTool::Stroke) addVector(record, at + "direction", e.direction);
  for (std::size_t k = 0; k < e.path.size(); k++)
    addVector(record, fmt::format("{}path.{}", at, k), e.path[k]);
  if (e.tool == CutTool::Box) addShape(record, at + "region.", e.region);
}

}  // namespace

void addCoefficients(CheckpointValues& record, const Material& m) {
  const std::string at = coefficient + ("material." + m.name + ".");
  addNumbers(record, at,
             {{"density", m.density},
              {"surface_tension", m.surfaceTension},
              {"sound_speed", m.soundSpeed},
              {"law", static_cast<double>(m.law)},
              {"volume_stiffness", m.volumeStiffness},
              {"hourglass", m.hourglass},
              {"break_stretch", m.breakStretch},
              {"damping", m.damping},
              {"friction", m.friction},
              {"restitution", m.restitution},
              {"latent_heat", m.latentHeat},
              {"solidus", m.solidus},
              {"liquidus", m.liquidus},
              {"hysteresis", m.hysteresis},
              {"heat_source", m.heatSource},
              {"emissivity", m.emissivity},
              {"convection", m.convection},
              {"paper_diffusivity", m.paperDiffusivity},
              {"xsph", m.xsph},
              {"artificial_viscosity", m.artificialViscosity},
              {"max_plastic_strain", m.maxPlasticStrain},
              {"hardening", m.hardening},
              {"weld", m.weld}});
  for (std::size_t k = 0; k < m.viscosityTable.size(); k++) {
    const std::string row = fmt::format("{}viscosity.{}.", at, k);
    addNumbers(record, row,
               {{"temperature", m.viscosityTable[k].first}, {"viscosity", m.viscosityTable[k].second}});
  }
  for (const auto& [key, blend] :
       std::initializer_list<std::pair<const char*, const Blend*>>{{"viscosity", &m.viscosity},
                                                                   {"young", &m.young},
                                                                   {"poisson", &m.poisson},
                                                                   {"yield_strain", &m.yieldStrain},
                                                                   {"creep_rate", &m.creepRate},
                                                                   {"conductivity", &m.conductivity},
                                                                   {"heat_capacity", &m.heatCapacity}})
    addBlend(record, at + key, *blend);
}

void addSettings(CheckpointValues& record, const SurfaceSettings& s) {
  addNumbers(record, std::string(setting) + "surface.",
             {{"spacing", s.spacing},
              {"support", s.support},
              {"particle_support", s.particleSupport},
              {"every_steps", static_cast<double>(s.everySteps)},
              {"every_move", s.everyMove},
              {"implicit", s.implicit},
              {"attract", s.attract},
              {"smooth", s.smooth},
              {"repel", s.repel},
              {"smoothing", static_cast<double>(s.smoothing)},
              {"iso_level", s.isoLevel},
              {"least_level", s.leastLevel},
              {"damping", s.damping},
              {"iterations", static_cast<double>(s.iterations)},
              {"stop", s.stop},
              {"adapt", s.adapt},
              {"keep_volume", s.keepVolume},
              {"merge", static_cast<double>(s.merge)},
              {"link_length", s.linkLength}});
  record[std::string(initialPrefix) + "surface.source"] = static_cast<double>(s.source);
}

void addCoefficients(CheckpointValues& record, const SheetBody& b) {
  const std::string at = coefficient + ("sheet." + b.name + ".");
  addNumbers(record, at,
             {{"plasticity", b.plasticity},
              {"elastic_limit", b.elasticLimit},
              {"rest_length", b.restLength},
              {"stretch_limit", b.stretchLimit},
              {"rigid", b.rigid},
              {"pull_reach", b.pullReach},
              {"thickness", b.thickness},
              {"contact_rate", b.contactRate},
              {"friction", b.friction},
              {"restitution", b.restitution},
              {"self_contact", b.selfContact},
              {"heat_capacity", b.heatCapacity},
              {"conductance", b.conductance}});
  addVector(record, at + "wind", b.wind);
  if (!b.wrapTo.empty())
    record[at + "wrap_to." + b.wrapTo] = 1;  // entries are numbers, so the name is part of the key
  for (std::size_t f = 0; f < sheetFactors; f++) {
    if (static_cast<SheetFactor>(f) == SheetFactor::Mass) continue;  // vertices keep their mass
    const auto& [key, value] = sheetCoefficients[f];
    record[at + key] = b.*value;
    addInTime(record, fmt::format("{}{}_in_time", at, key), b.inTime[f]);
    for (std::size_t k = 0; k < b.regions.size(); k++)
      record[fmt::format("{}region.{}.{}", at, k, key)] = b.regions[k].factor[f];
  }
  for (std::size_t k = 0; k < b.brushes.size(); k++) {
    const std::string brush = fmt::format("{}brush.{}.", at, k);
    record[brush + "radius"] = b.brushes[k].radius;
    addVector(record, brush + "centre", b.brushes[k].centre);
    addVector(record, brush + "pressure", b.brushes[k].pressure);
    addInTime(record, brush + "in_time", b.brushes[k].inTime);
    addMotion(record, brush, b.brushes[k].motion);
  }
}

void addCoefficients(CheckpointValues& record, const OrientedBody& b) {
  const std::string at = coefficient + ("oriented." + b.name + ".");
  addNumbers(record, at,
             {{"stiffness", b.stiffness},
              {"attract", b.attract},
              {"coplanar", b.plane},
              {"conormal", b.normal},
              {"cocircular", b.circle},
              {"repel_power", static_cast<double>(b.repelPower)},
              {"attract_power", static_cast<double>(b.attractPower)},
              {"core", b.core},
              {"across", b.across},
              {"along", b.along},
              {"support", b.support},
              {"facing", b.facing},
              {"planar", b.planar},
              {"damping", b.damping},
              {"spin_damping", b.spinDamping},
              {"pressure", b.pressure},
              {"contact", b.contact},
              {"thickness", b.thickness},
              {"friction", b.friction},
              {"integrator", static_cast<double>(b.integrator)}});
  addNumbers(record, setting + ("oriented." + b.name + "."),
             {{"growth", static_cast<double>(b.growth)},
              {"gap", b.gap},
              {"crowd", b.crowd},
              {"every", static_cast<double>(b.every)},
              {"most", static_cast<double>(b.most)},
              {"cfl", b.cfl}});
  const std::string events = setting + ("oriented." + b.name + ".");
  for (std::size_t k = 0; k < b.events.size(); k++)
    addEvent(record, fmt::format("{}event.{}.", events, k), b.events[k]);
  addVector(record, at + "push", b.push);
  for (std::size_t k = 0; k < b.fields.size(); k++) {
    const OrientedField& f = b.fields[k];
    const std::string field = fmt::format("{}field.{}.", at, k);
    addNumbers(record, field,
               {{"pull", f.pull},
                {"radius", f.radius},
                {"pressure", f.pressure},
                {"from", f.from},
                {"until", f.until},
                {"everywhere", f.everywhere}});
    addVector(record, field + "push", f.push);
    addVector(record, field + "point", f.point);
    addInTime(record, field + "in_time", f.inTime);
    if (!f.everywhere) addShape(record, field + "region.", f.region);
  }
  for (std::size_t k = 0; k < b.anchors.size(); k++) {
    const std::string anchor = fmt::format("{}anchor.{}.", at, k);
    record[anchor + "until"] = b.anchors[k].until;
    addMotion(record, anchor, b.anchors[k].motion);
  }
}

void addCoefficients(CheckpointValues& record, const Obstacle& o) {
  const std::string at = coefficient + ("obstacle." + o.name + ".");
  addNumbers(record, at,
             {{"conductance", o.conductance},
              {"friction", o.friction},
              {"restitution", o.restitution},
              {"slip", o.slip},
              {"until", o.until}});
  if (o.temperature) record[at + "temperature"] = *o.temperature;
  addShape(record, at + "shape.", o.shape);
  addMotion(record, at, o.motion);
}

void addCoefficients(CheckpointValues& record, const Domain& d) {
  const std::string at = coefficient + std::string("domain.");
  record[at + "ambient"] = d.ambient;
  constexpr const char* ends[3][2] = {
      {"wall.x.low", "wall.x.high"}, {"wall.y.low", "wall.y.high"}, {"wall.z.low", "wall.z.high"}};
  for (std::size_t a = 0; a < 3; a++)
    for (std::size_t end = 0; end < 2; end++) record[at + ends[a][end]] = d.side[a][end] == Side::Wall;
}

void addCoefficients(CheckpointValues& record, const Numerics& n) {
  const auto number = [](auto choice) { return static_cast<double>(choice); };
  addNumbers(record, coefficient + std::string("numerics."),
             {{"kernel", number(n.kernel)},
              {"precision", number(n.precision)},
              {"elastic_precision", number(n.elasticPrecision)},
              {"pressure", number(n.pressure)},
              {"density", number(n.density)},
              {"corrected_gradients", n.correctedGradients},
              {"density_diffusion", n.densityDiffusion},
              {"shifting", n.shifting},
              {"equation_of_state", number(n.eos)},
              {"tensile_limit", n.tensileLimit},
              {"pressure_solver", number(n.solver)},
              {"viscosity", number(n.viscosity)},
              {"viscosity_correction", n.viscosityCorrection},
              {"viscosity_solver", number(n.viscositySolver)},
              {"tension", number(n.tension)},
              {"conduction", number(n.conduction)},
              {"self_contact", n.selfContact},
              {"max_density_error", n.maxDensityError}});
  addNumbers(record, setting + std::string("numerics."),
             {{"density_tolerance", n.densityTolerance},
              {"divergence_tolerance", n.divergenceTolerance},
              {"max_iterations", number(n.maxIterations)},
              {"viscosity_tolerance", n.viscosityTolerance},
              {"viscosity_iterations", number(n.viscosityIterations)},
              {"fixed_step", n.fixedStep},
              {"max_step", n.maxStep},
              {"cfl_sound", n.cflSound},
              {"cfl_viscous", n.cflViscous},
              {"cfl_heat", n.cflHeat},
              {"cfl_elastic", n.cflElastic},
              {"cfl_tension", n.cflTension},
              {"cfl_acceleration", n.cflAcceleration},
              {"elastic_substeps", number(n.elasticSubsteps)},
              {"sleep_speed", n.sleepSpeed},
              {"sleep_after", n.sleepAfter},
              {"sleep_heating", n.sleepHeating},
              {"plastic_rereference", n.plasticRereference}});
}

void addExpectedSpeed(CheckpointValues& record, const Scene& s) {
  const auto automatic = [](const Material& m) { return canBeLiquid(m) && m.soundSpeed == 0; };
  if (std::any_of(s.materials.begin(), s.materials.end(), automatic))
    record[coefficient + std::string("numerics.expected_speed")] = expectedFlow(s).speed;
}

void addSettings(CheckpointValues& record, const Emitter& e) {
  const std::string at = setting + ("emitter." + e.name + ".");
  addNumbers(record, at, {{"end", e.end}, {"temperature", e.temperature}});
  addField(record, at + "temperature", e.temperatureField);
}

void addSettings(CheckpointValues& record, const Thermostat& t, std::size_t number) {
  addNumbers(
      record, fmt::format("{}temper.{}.", setting, number),
      {{"material", t.material}, {"start", t.start}, {"over", t.over}, {"temperature", t.temperature}});
}

}  // namespace thaw
