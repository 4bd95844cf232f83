// SPDX-License-Identifier: Apache-2.0
#include "core/terms/find_modules.hpp"

#include <algorithm>
#include <iterator>

#include "core/scene/buoyancy.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/phase_density.hpp"
#include "core/terms/extensions.hpp"

namespace thaw {
namespace {

std::string quoted(const std::string& name) { return "'" + name + "'"; }

bool liquidAt(const Material& m, double T) {
  return !m.canBeSolid() || (m.melts() ? T > m.solidus : m.liquidAtStart);
}

/// "sheet 'a'", or "sheets 'a', 'b' and 'c'".
template<class Body> std::string namesOf(const char* one, const char* more, const std::vector<Body>& bodies) {
  std::string text = std::string(bodies.size() > 1 ? more : one) + " ";
  for (std::size_t k = 0; k < bodies.size(); k++)
    text += (k == 0 ? "" : k + 1 == bodies.size() ? " and " : ", ") + quoted(bodies[k].name);
  return text;
}

struct Finder {
  const Scene& s;
  Modules m;
  void on(bool& module, const char* name, const std::string& why) {
    if (module) return;
    module = true;
    m.why.push_back(std::string(name) + ": " + why);
  }
};

/// Activates the modules of terms of the model: of those that heat, or of the others.
void findTerms(Finder& f, bool heat) {
  for (const Extension* term : modelTerms()) {
    if (term->heats != heat || !term->model->uses) continue;
    bool listed = false;  // a term without a module of its own
    for (const ModuleUse& use : term->model->uses(f.s, f.m))
      f.on(use.module ? f.m.*use.module : listed, use.name, use.why);
  }
}

/// Activates heat if temperatures differ or something heats or cools.
void findHeat(Finder& f) {
  const Scene& s = f.s;
  bool conducts = false;
  for (const Material& m : s.materials)
    conducts = conducts || m.conductivity.solid > 0 || m.conductivity.liquid > 0 || m.paperDiffusivity > 0;
  const bool matters = conducts || hasBuoyancy(s);  // differences of temperature
  double first = NAN;
  const auto seen = [&](double T, const std::string& who) {
    if (std::isnan(first)) first = T;
    else if (T != first && matters) f.on(f.m.heat, "heat", who + " differs in temperature from other bodies");
  };
  // A temperature field matters if heat is conducted, or if it decides the phase.
  const auto field = [&](const auto& source, const std::string& who) {
    if (!source.temperatureField) return seen(source.temperature, who);
    if (matters || s.materials[static_cast<std::size_t>(source.material)].melts())
      f.on(f.m.heat, "heat", who + " has a temperature that depends on position");
  };
  for (const Body& b : s.bodies) {
    field(b, "body " + quoted(b.name));
    if (length(b.temperatureGradient) > 0 && matters)
      f.on(f.m.heat, "heat", "body " + quoted(b.name) + " has a temperature gradient");
  }
  for (const Emitter& e : s.emitters) field(e, "emitter " + quoted(e.name));
  for (const Obstacle& o : s.obstacles)
    if (o.temperature && conducts)
      f.on(f.m.heat, "heat", "obstacle " + quoted(o.name) + " has a temperature");
  findTerms(f, true);
  if (hasContinuum(s))
    for (const ExtensionSettings& e : s.extensions)
      if (e.heats) f.on(f.m.heat, "heat", "extension " + quoted(e.name) + " heats bodies");
  for (const Material& m : s.materials) {
    if (!m.evaporation.empty()) f.on(f.m.heat, "heat", "material " + quoted(m.name) + " evaporates");
    if (m.weldTemperature < never)
      f.on(f.m.heat, "heat", "pieces of material " + quoted(m.name) + " weld where they are hot");
    if (!m.viscosityTable.empty() || m.flowLaw.consistency.size() > 1 || m.flowLaw.yieldStress.size() > 1)
      f.on(f.m.heat, "heat", "the viscosity of material " + quoted(m.name) + " depends on the temperature");
    if (!m.surfaceTensionTable.empty())
      f.on(f.m.heat, "heat",
           "the surface tension of material " + quoted(m.name) + " depends on the temperature");
  }
}

/// Returns true if everything is liquid of one material with constant parameters and no pair sum reads data
/// other than positions and velocities. With heat, no sum may need volumes after the densities
/// (terms/uniform_forces.hpp).
bool isUniform(const Scene& s, const Modules& m) {
  const bool other = m.solid || m.melting || m.contactConductance || m.evaporation || m.incompressible ||
                     m.implicitViscosity || m.viscosityCorrection || m.tension || m.bodyTypes();
  const bool volumes = m.heat && (m.xsph || m.surfaceHeat || s.numerics.pressure != PairForm::Consistent);
  const bool otherCarried = m.continuity &&
                            (!m.corrected || m.heat || m.xsph || s.numerics.pressure != PairForm::Consistent);
  return m.fluid && !other && !volumes && !otherCarried && s.materials.size() == 1 &&
         s.materials[0].viscosityTable.empty() && !m.flowLaw && s.numerics.kernel == KernelKind::WendlandC2 &&
         s.numerics.viscosity == ViscosityForm::Pairwise;
}

/// Activates surfaces, further body types and emitters.
void findBodyTypes(Finder& f) {
  const Scene& s = f.s;
  Modules& m = f.m;
  if (s.surface.on) f.on(m.surface, "surface", "the scene has a table [surface]");
  if (!s.oriented.empty())
    f.on(m.oriented, "oriented particles", namesOf("oriented body", "oriented bodies", s.oriented));
  if (!s.sheets.empty()) f.on(m.sheet, "sheets", namesOf("sheet", "sheets", s.sheets));
  if (!s.sheets.empty() && !(s.bodies.empty() && s.emitters.empty()))
    f.on(m.neighbours, "neighbour search", "sheets can touch bodies");
  std::vector<SheetBody> warmed;
  std::copy_if(s.sheets.begin(), s.sheets.end(), std::back_inserter(warmed),
               [](const SheetBody& b) { return b.conductance > 0; });
  if (!warmed.empty())
    f.on(m.heat, "heat",
         namesOf("sheet", "sheets", warmed) + (warmed.size() > 1 ? " exchange" : " exchanges") +
             " heat with the bodies that " + (warmed.size() > 1 ? "they touch" : "it touches"));
  if (!s.emitters.empty()) f.on(m.emitters, "emitters", namesOf("emitter", "emitters", s.emitters));
}

/// Activates solid, fluid and melting. Sets used[k] for the materials of bodies and emitters. Returns the
/// number of solid bodies.
int findPhases(Finder& f, std::vector<bool>& used) {
  const Scene& s = f.s;
  Modules& m = f.m;
  int solidBodies = 0;
  const auto source = [&](const auto& from, const std::string& who, bool body) {
    const Material& x = s.materials[static_cast<std::size_t>(from.material)];
    used[static_cast<std::size_t>(from.material)] = true;
    const bool either = from.temperatureField && x.canBeSolid() && x.melts();
    if (either || solidAt(x, from.temperature)) {
      f.on(m.solid, "solid", who + (either ? " can be solid" : " is solid"));
      solidBodies += body;
    }
    if (either || liquidAt(x, from.temperature))
      f.on(m.fluid, "fluid", who + (either ? " can be liquid" : " is liquid"));
    if (m.heat && x.melts()) {
      f.on(m.melting, "melting",
           who + " is of material " + quoted(x.name) + ", which melts, and the scene has heat");
      f.on(m.fluid, "fluid", who + " can melt");
      if (x.canBeSolid()) f.on(m.solid, "solid", who + " can freeze");
    }
  };
  for (const Body& b : s.bodies) source(b, "body " + quoted(b.name), true);
  for (const Emitter& e : s.emitters) source(e, "emitter " + quoted(e.name), false);
  return solidBodies;
}

/// Activates the modules that the liquid of a material needs, if the scene can have such liquid.
void findLiquidLaws(Finder& f, const Material& x, const std::string& who) {
  const Numerics& n = f.s.numerics;
  Modules& m = f.m;
  if (!hasLiquid(m, x)) return;
  if (hasFlowLaw(x)) f.on(m.flowLaw, "flow law", "the viscosity of " + who + " depends on the shear rate");
  const bool viscous = x.viscosity.solid > 0 || x.viscosity.liquid > 0 || !x.viscosityTable.empty() ||
                       hasFlowLaw(x);
  if (viscous && n.viscositySolver == ViscositySolver::Implicit)
    f.on(m.implicitViscosity, "implicit viscosity", who);
  if (viscous && n.viscosityCorrection) f.on(m.viscosityCorrection, "corrected viscosity", who);
  if (m.continuity && x.bulkDamping > 0) f.on(m.bulkDamping, "bulk damping", who);
  if (!x.evaporation.empty())
    f.on(m.evaporation, "evaporation", who + " loses mass at free surfaces of its liquid");
}

/// Activates contact conductance and drag of mushes.
void findHeatLaws(Finder& f, const Material& x, const std::string& who) {
  const Scene& s = f.s;
  Modules& m = f.m;
  if (m.heat && x.contactConductance < never && s.bodies.size() + s.emitters.size() > 1)
    f.on(m.contactConductance, "contact conductance",
         "heat from " + who + " to other bodies meets a resistance");
  if (m.melting && x.melts() && x.mushDrag > 0)
    f.on(m.mushDrag, "mush drag", who + " slows its liquid beside solids between solidus and liquidus");
}

/// Activates the modules that the solid of a material needs.
void findSolidLaws(Finder& f, const Material& x, const std::string& who) {
  Modules& m = f.m;
  if (!m.solid || !x.canBeSolid()) return;
  if (hasPhaseDensities(x))
    f.on(m.phaseDensity, "density by phase", "solid and liquid of " + who + " differ in density");
  if (x.yieldStrain.solid < never || x.yieldStrain.liquid < never)
    f.on(m.plastic, "plastic flow", who + " yields");
  if (x.breakStretch < never) f.on(m.fracture, "fracture", "bonds of " + who + " break");
  if (x.melts() && m.melting) f.on(m.freezing, "freezing", who + " can freeze again");
}

/// Activates rigid pieces. Returns true if some solid has bonds.
bool findRigid(Finder& f, const std::vector<bool>& used) {
  const Scene& s = f.s;
  Modules& m = f.m;
  bool elastic = false;
  for (std::size_t k = 0; k < s.materials.size() && m.solid; k++) {
    const Material& x = s.materials[k];
    if (!used[k] || !x.canBeSolid()) continue;
    if (x.isRigid()) f.on(m.rigid, "rigid pieces", "the law of material " + quoted(x.name) + " is \"rigid\"");
    else elastic = true;
    if (x.isRigid() && x.rollingFriction > 0)
      f.on(m.rollingFriction, "rolling friction", "material " + quoted(x.name) + " has a `rolling_friction`");
    if (x.isRigid() && x.strength < never)
      f.on(m.breaking, "breaking of rigid pieces", "material " + quoted(x.name) + " has a strength");
    if (x.isRigid() && x.weldTemperature < never)
      f.on(m.pieceWelding, "welding of rigid pieces",
           "material " + quoted(x.name) + " has a `weld_temperature`");
  }
  if (elastic && s.numerics.rigidify > 0) {
    f.on(m.rigidify, "rigid parts of elastic solids", "`numerics.rigidify` is given");
    f.on(m.rigid, "rigid pieces", "`numerics.rigidify` is given");
  }
  if (m.rigid) f.on(m.neighbours, "neighbour search", "rigid pieces can touch");
  return elastic;
}

/// Returns true if an emitter can emit solids.
bool emitsSolid(const Scene& s) {
  return std::any_of(s.emitters.begin(), s.emitters.end(), [&](const Emitter& e) {
    const Material& m = s.materials[static_cast<std::size_t>(e.material)];
    return m.canBeSolid() && (e.temperatureField || solidAt(m, e.temperature));
  });
}

/// Activates contact of solids and welding. Requires: Modules::elastic.
void findContact(Finder& f, const std::vector<bool>& used, int solidBodies) {
  const Scene& s = f.s;
  Modules& m = f.m;
  if (m.solid) {
    if (solidBodies > 1) f.on(m.contact, "contact of solids", "there are several solid bodies");
    if (m.freezing) f.on(m.contact, "contact of solids", "frozen pieces can touch");
    if (m.fracture && s.numerics.selfContact) f.on(m.contact, "contact of solids", "pieces can touch");
  }
  if (m.contact && m.elastic && s.bodies.size() + s.emitters.size() > 1)
    f.on(m.bodyContact, "contact of bodies", "solids of different bodies can touch");
  m.rareContact = m.contact && solidBodies <= 1 && !m.fracture && !emitsSolid(s);
  if (m.contact)
    for (std::size_t k = 0; k < s.materials.size(); k++)
      if (used[k] && s.materials[k].weld && s.materials[k].canBeSolid())
        f.on(m.welding, "welding", "solids of material " + quoted(s.materials[k].name) + " grow together");
}

/// Activates sleep, and substeps of solids. Requires: Modules::elastic.
void findSubsteps(Finder& f) {
  const Scene& s = f.s;
  Modules& m = f.m;
  if (m.solid && s.numerics.sleepSpeed > 0)
    f.on(m.rigid && !m.elastic ? m.pieceSleep : m.sleep, "sleep", "`numerics.sleep_speed` is given");
  // Contact of solids limits the step of all particles, so substeps gain little there. With more than two
  // substeps, impulses of incompressible liquid come as seldom as half a period of the fastest elastic waves,
  // and feed these waves.
  const int byDefault = m.incompressible ? 2 : 4;
  m.mostSubsteps = s.numerics.elasticSubsteps > 0 ? s.numerics.elasticSubsteps
                   : m.elastic && m.fluid && !m.contact && !m.sleep && !m.rigidify ? byDefault
                                                                                   : 1;
  m.rareContact = m.rareContact && m.mostSubsteps > 1;
  if (m.solid && m.mostSubsteps > 1)
    f.on(m.substeps, "substeps of solids",
         s.numerics.elasticSubsteps > 0
             ? "`numerics.elastic_substeps` is " + std::to_string(m.mostSubsteps)
             : "the scene also has liquid: up to " + std::to_string(m.mostSubsteps));
}

/// Activates the neighbour search for modules that need it, and contacts between body types.
void findNeighbourUse(Finder& f) {
  Modules& m = f.m;
  if (m.fluid) f.on(m.neighbours, "neighbour search", "there is liquid");
  if (m.contact) f.on(m.neighbours, "neighbour search", "solids can touch");
  if (m.oriented && (m.fluid || m.solid)) {
    f.on(m.orientedContact, "contact of body types", "the scene has oriented particles and continuum bodies");
    f.on(m.neighbours, "neighbour search", "oriented particles can touch the continuum");
  }
  if (m.oriented && m.sheet)
    f.on(m.sheetContact, "contact of sheets and oriented particles", "the scene has both");
  if (m.heat) f.on(m.neighbours, "neighbour search", "heat is conducted");
  if (m.sleep) f.on(m.neighbours, "neighbour search", "moving bodies wake sleeping neighbours");
}

}  // namespace

Modules modulesOf(const Scene& s) {
  Finder f{s, {}};
  Modules& m = f.m;
  findHeat(f);
  findBodyTypes(f);
  std::vector<bool> used(s.materials.size(), false);
  const int solidBodies = findPhases(f, used);
  if (m.fluid && s.numerics.density == DensityForm::Continuity)
    f.on(m.continuity, "density by continuity", "liquid with `numerics.density = \"continuity\"`");
  if (m.continuity && s.numerics.correctedGradients)
    f.on(m.corrected, "corrected gradients", "numerics.corrected_gradients");
  if (m.fluid && s.numerics.shifting > 0) f.on(m.shifting, "shifting of particles", "numerics.shifting");
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    if (!used[k]) continue;
    const std::string who = "material " + quoted(s.materials[k].name);
    findLiquidLaws(f, s.materials[k], who);
    findHeatLaws(f, s.materials[k], who);
    findSolidLaws(f, s.materials[k], who);
  }
  m.elastic = findRigid(f, used);
  findContact(f, used, solidBodies);
  if (m.fluid && s.numerics.solver == PressureSolver::Incompressible)
    f.on(m.incompressible, "incompressible liquid", "numerics.pressure_solver");
  findSubsteps(f);
  findNeighbourUse(f);
  findTerms(f, false);
  m.uniform = isUniform(s, m);
  return f.m;
}

}  // namespace thaw
