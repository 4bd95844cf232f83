// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/scene/full_box.hpp"
#include "core/terms/extensions.hpp"
#include "io/scene/tables/full_box.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/nearest_word.hpp"

namespace thaw {
namespace {

void checkSurface(const Scene& scene, std::vector<SceneError>& errors) {
  const SurfaceSettings& s = scene.surface;
  const auto placeOf = [&](std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (const auto at = s.places.find(key); at != s.places.end()) return at->second;
    return s.where;
  };
  if (s.leastLevel >= s.isoLevel)
    errors.push_back({placeOf({"least_level", "iso_level"}),
                      fmt::format("`surface.least_level` ({:g}) must be below `surface.iso_level` ({:g}), "
                                  "the level of the surface",
                                  s.leastLevel, s.isoLevel)});
  if (s.spacing > 0 && s.spacing < 1e-3 * scene.spacing)
    errors.push_back({placeOf({"spacing"}),
                      fmt::format("`surface.spacing` ({:g} m) is too fine: expected at least a thousandth of "
                                  "`spacing` ({:g} m)",
                                  s.spacing, scene.spacing)});
}

/// Returns the place of the first of these keys of [numerics] in the scene, or the start of the file.
SourcePlace placeOf(const SceneReading& x, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const auto at = x.numerics.find(key); at != x.numerics.end()) return at->second;
  return x.start;
}

/// Adds an error for a name that another element of the list has. lines: of the first use, by name.
void checkUnique(const std::string& name, const SourcePlace& where, const char* kind,
                 std::map<std::string, int>& lines, std::vector<SceneError>& errors) {
  const auto [first, isNew] = lines.insert({name, where.line});
  if (!isNew)
    errors.push_back(
        {where, fmt::format("duplicate {} name '{}'{}", kind, name,
                            first->second > 0 ? fmt::format("; first used in line {}", first->second) : "")});
}

/// "heated region 'sun'", or "thermostat" for elements without names.
std::string ownerOf(const TermTable& table, const TermElement& one) {
  return one.name ? fmt::format("{} '{}'", table.title, *one.name) : table.title;
}

/// Checks names of lamps and other sources, and refuses sources that have nothing to heat.
void checkTermElements(Scene& s, std::vector<SceneError>& errors) {
  std::map<const TermTable*, std::map<std::string, int>> lines;
  eachTermElement(s, [&](const Extension& term, const TermTable& table, const TermElement& one) {
    if (one.name) checkUnique(*one.name, *one.where, table.title, lines[&table], errors);
    if (term.model->stage == LoadStage::Sources && !hasContinuum(s))
      errors.push_back({*one.where, ownerOf(table, one) +
                                        ": the scene has no [[body]] and no [[emitter]] that it can heat; it "
                                        "heats no sheets or oriented particles"});
  });
}

}  // namespace

void checkScene(SceneReading& x, std::vector<SceneError>& errors) {
  Scene& s = *x.scene;
  std::set<std::string> names;
  for (const Material& m : s.materials) names.insert(m.name);
  const auto resolve = [&](const MaterialName& m, const std::string& who, int& index) {
    for (std::size_t k = 0; k < s.materials.size(); k++)
      if (s.materials[k].name == m.name) return static_cast<void>(index = static_cast<int>(k));
    const std::string what = m.name.empty() ? "its material is missing: expected `material`"
                                            : "unknown material '" + m.name + "'" + suggestion(m.name, names);
    if (!m.reported && x.materials)
      errors.push_back({m.where, who + ": " + what, SceneError::Kind::Value, "material"});
  };
  for (std::size_t b = 0; b < s.bodies.size(); b++)
    resolve(x.bodyMaterials[b], "body '" + s.bodies[b].name + "'", s.bodies[b].material);
  for (std::size_t e = 0; e < s.emitters.size(); e++)
    resolve(x.emitterMaterials[e], "emitter '" + s.emitters[e].name + "'", s.emitters[e].material);
  for (const TermMaterial& t : x.termMaterials) {
    if (t.name.name.empty()) continue;
    const TermElement one = t.table->at(s, t.index);
    resolve(t.name, ownerOf(*t.table, one), *one.material);
  }

  const auto unique = [&](const auto& list, const char* kind) {
    std::map<std::string, int> lines;
    for (const auto& item : list) checkUnique(item.name, item.where, kind, lines, errors);
  };
  unique(s.bodies, "body");
  unique(s.emitters, "emitter");
  unique(s.oriented, "oriented body");
  unique(s.sheets, "sheet");
  unique(s.obstacles, "obstacle");
  checkTermElements(s, errors);
  checkSheets(s, errors);
  checkOrientedEvents(x, errors);
  if (s.bodies.empty() && s.emitters.empty() && s.oriented.empty() && s.sheets.empty())
    errors.push_back({x.start,
                      "there is nothing to simulate: a scene needs a [[body]] or an [[emitter]] and its "
                      "[material.NAME], an [[oriented]] or a [[sheet]]; all else has defaults"});
  if (s.numerics.heat == HeatModel::Paper)
    for (const Material& m : s.materials)
      if (m.paperDiffusivity == 0 && (m.conductivity.solid > 0 || m.conductivity.liquid > 0))
        errors.push_back(
            {m.where, fmt::format("material.{}: with `numerics.heat = \"paper\"` heat spreads by "
                                  "`paper_diffusivity`, not by `conductivity`: set it instead",
                                  m.name)});
  const auto solid = std::find_if(s.materials.begin(), s.materials.end(),
                                  [](const Material& m) { return m.canBeSolid(); });
  if (solid != s.materials.end() && s.numerics.bondSupport > s.numerics.support)
    errors.push_back(
        {solid->where,
         fmt::format("material.{} can be solid, and `numerics.bond_support` ({:g}) is above "
                     "`numerics.support` ({:g}), the radius of the neighbour search: make it smaller",
                     solid->name, s.numerics.bondSupport, s.numerics.support)});
  const Numerics& n = s.numerics;
  if (n.sleepSpeed > 0) {
    const auto refuse = [&](bool is, const char* what) {
      if (is)
        errors.push_back(
            {placeOf(x, {"sleep_speed"}), std::string("`numerics.sleep_speed` cannot be combined with ") +
                                              what + ": leave one of them out"});
    };
    refuse(n.elasticSubsteps > 1, "`numerics.elastic_substeps` above 1");
    refuse(n.solver == PressureSolver::Incompressible, "`numerics.pressure_solver = \"incompressible\"`");
    refuse(n.viscositySolver == ViscositySolver::Implicit, "`numerics.viscosity_solver = \"implicit\"`");
    refuse(!s.oriented.empty(), "tables [[oriented]]");
    refuse(!s.sheets.empty(), "tables [[sheet]]");
  }
  checkRigid(x, errors);
  if (n.solver == PressureSolver::Incompressible && n.pressure == PairForm::Printed)
    errors.push_back(
        {placeOf(x, {"pressure", "pressure_solver"}),
         "`numerics.pressure_solver = \"incompressible\"` needs "
         "`numerics.pressure = \"consistent\"`: the printed form has no potential to solve for"});
  if (n.solver == PressureSolver::Incompressible && n.tensileLimit > 0 && n.tensileLimit < 1)
    errors.push_back(
        {placeOf(x, {"tensile_limit"}),
         "with `numerics.pressure_solver = \"incompressible\"` `numerics.tensile_limit` must be 0 "
         "(no tension in liquid) or 1 (full tension, for boxes filled with liquid)"});
  if (s.surface.on) checkSurface(s, errors);
  if (n.support < 2)
    for (const Material& m : s.materials)
      if (m.convection > 0 || m.emissivity > 0 || !m.evaporation.empty())
        errors.push_back(
            {m.where,
             fmt::format(
                 "material.{}: convection, emissivity and evaporation need `numerics.support` of at least 2, "
                 "got {:g}: with fewer neighbours, inner particles would count as surface particles",
                 m.name, n.support)});
  checkBuoyancy(x, errors);
  checkTension(s, errors);
  checkSizes(x, errors);
  if (n.solver == PressureSolver::Incompressible && n.density == DensityForm::Continuity && !x.open.density)
    errors.push_back(
        {placeOf(x, {"density", "pressure_solver"}),
         "`numerics.density = \"continuity\"` needs the equation of state, and "
         "`numerics.pressure_solver = \"incompressible\"` corrects summed densities: remove one"});
  // The density of a quality belongs to the consistent form of the equation of state.
  if (x.open.density && (n.solver == PressureSolver::Incompressible || n.pressure == PairForm::Printed))
    s.numerics.density = Numerics().density;
  if (!errors.empty()) return;
  chooseBuoyancy(s);
  chooseForFullBox(s, x.open);
  chooseForLiquids(s, x.open);
  chooseForThickLiquids(s, x.open);
  checkCurvature(s, placeOf(x, {"tension", "density", "shifting", "pressure_solver"}), errors);
  if (n.tensileLimit == 0 || n.solver == PressureSolver::Incompressible || liquidFillsTheBox(s)) return;
  if (n.shifting == 0)
    errors.push_back({placeOf(x, {"tensile_limit", "shifting"}),
                      "`numerics.tensile_limit` above 0 needs `numerics.shifting` above 0 (0.2 is "
                      "recommended, with `density = \"continuity\"`): without shifting, negative pressure "
                      "makes particles form clusters"});
  else if (n.density != DensityForm::Continuity)
    errors.push_back({placeOf(x, {"tensile_limit", "density"}),
                      "`numerics.tensile_limit` above 0 needs `numerics.density = \"continuity\"`: a summed "
                      "density is low at a free surface and causes tension there"});
}

}  // namespace thaw
