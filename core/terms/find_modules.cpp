// SPDX-License-Identifier: Apache-2.0
#include "core/terms/find_modules.hpp"

#include <algorithm>
#include <iterator>

#include "core/scene/material_use.hpp"
#include "core/terms/extensions.hpp"
#include "core/terms/solid_uses.hpp"

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
  /// Activates a module of a term.
  void on(bool Modules::*module, const std::string& why) { on(m.*module, nameOf(module), why); }
};

void activate(Finder& f, const std::vector<ModuleUse>& uses) {
  for (const ModuleUse& use : uses) f.on(use.module, use.why);
}

/// Activates the modules that terms need before phases are known. heat: true for terms that heat, false for
/// other terms.
void findEarly(Finder& f, bool heat) {
  for (const Extension* term : modelTerms())
    if (term->heats == heat && term->model->earlyUses) activate(f, term->model->earlyUses(f.s));
}

/// Activates the other modules of terms.
void findTerms(Finder& f) {
  for (const Extension* term : modelTerms())
    if (term->model->uses) activate(f, term->model->uses(f.s, f.m));
}

/// Activates heat if something heats or cools, or if a temperature decides a phase.
void findHeat(Finder& f) {
  const Scene& s = f.s;
  findEarly(f, true);
  if (hasContinuum(s))
    for (const ExtensionSettings& e : s.extensions)
      if (e.heats) f.on(&Modules::heat, "extension " + quoted(e.name) + " heats bodies");
  const auto field = [&](const auto& source, const std::string& who) {
    if (source.temperatureField && s.materials[static_cast<std::size_t>(source.material)].melts())
      f.on(&Modules::heat, who + " has a temperature that depends on position");
  };
  for (const Body& b : s.bodies) field(b, "body " + quoted(b.name));
  for (const Emitter& e : s.emitters) field(e, "emitter " + quoted(e.name));
  findEarly(f, false);
}

/// Returns true if everything is liquid of one material with constant parameters, and pair sums read only
/// positions and velocities. With heat, no sum may need volumes after the densities
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
    f.on(&Modules::heat,
         namesOf("sheet", "sheets", warmed) + (warmed.size() > 1 ? " exchange" : " exchanges") +
             " heat with the bodies that " + (warmed.size() > 1 ? "they touch" : "it touches"));
  if (!s.emitters.empty()) f.on(m.emitters, "emitters", namesOf("emitter", "emitters", s.emitters));
}

/// Activates solid, fluid and melting.
void findPhases(Finder& f) {
  const Scene& s = f.s;
  Modules& m = f.m;
  const auto source = [&](const auto& from, const std::string& who) {
    const Material& x = materialOf(s, from);
    const bool either = mayStartInEitherPhase(s, from);
    if (mayStartSolid(s, from)) f.on(&Modules::solid, who + (either ? " can be solid" : " is solid"));
    if (either || liquidAt(x, from.temperature))
      f.on(m.fluid, "fluid", who + (either ? " can be liquid" : " is liquid"));
    if (m.heat && x.melts()) {
      f.on(&Modules::melting,
           who + " is of material " + quoted(x.name) + ", which melts, and the scene has heat");
      f.on(m.fluid, "fluid", who + " can melt");
      if (x.canBeSolid()) f.on(&Modules::solid, who + " can freeze");
    }
  };
  for (const Body& b : s.bodies) source(b, "body " + quoted(b.name));
  for (const Emitter& e : s.emitters) source(e, "emitter " + quoted(e.name));
}

/// Activates rigid pieces. Returns true if some solid has bonds.
bool findRigid(Finder& f) {
  const Scene& s = f.s;
  Modules& m = f.m;
  bool elastic = false;
  for (std::size_t k = 0; k < s.materials.size() && m.solid; k++) {
    const Material& x = s.materials[k];
    if (!inUse(s, k) || !x.canBeSolid()) continue;
    if (x.isRigid()) f.on(m.rigid, "rigid pieces", "the law of material " + quoted(x.name) + " is \"rigid\"");
    else elastic = true;
  }
  if (elastic && s.numerics.rigidify > 0) {
    f.on(m.rigidify, "rigid parts of elastic solids", "`numerics.rigidify` is given");
    f.on(m.rigid, "rigid pieces", "`numerics.rigidify` is given");
  }
  if (m.rigid) f.on(m.neighbours, "neighbour search", "rigid pieces can touch");
  return elastic;
}

/// Activates sleep, and substeps of solids. Requires: Modules::elastic.
void findSubsteps(Finder& f) {
  const Scene& s = f.s;
  Modules& m = f.m;
  if (m.solid && s.numerics.sleepSpeed > 0)
    f.on(m.rigid && !m.elastic ? m.pieceSleep : m.sleep, "sleep", "`numerics.sleep_speed` is given");
  // Contact of solids limits the step of all particles, so substeps gain little there. With more than two
  // substeps, the interval between impulses of incompressible liquid reaches half a period of the fastest
  // elastic waves. The impulses then amplify these waves.
  const int byDefault = m.incompressible ? 2 : 4;
  m.mostSubsteps = s.numerics.elasticSubsteps > 0 ? s.numerics.elasticSubsteps
                   : m.elastic && m.fluid && !m.contact && !m.sleep && !m.rigidify ? byDefault
                                                                                   : 1;
  const bool emitsSolid = std::any_of(s.emitters.begin(), s.emitters.end(),
                                      [&](const Emitter& e) { return mayStartSolid(s, e); });
  m.rareContact = m.contact && m.mostSubsteps > 1 && solidBodies(s) <= 1 && !m.fracture && !emitsSolid;
  if (m.solid && m.mostSubsteps > 1)
    f.on(&Modules::substeps, s.numerics.elasticSubsteps > 0
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
  findPhases(f);
  m.elastic = findRigid(f);
  findTerms(f);
  findSubsteps(f);
  findNeighbourUse(f);
  m.uniform = isUniform(s, m);
  return f.m;
}

}  // namespace thaw
