// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/scene/buoyancy.hpp"
#include "core/scene/modules.hpp"
#include "core/terms/extensions.hpp"
#include "io/frames/frame_fields.hpp"
#include "io/scene/surface_advice.hpp"
#include "io/scene/text/nearest_word.hpp"
#include "io/scene/text/path_names.hpp"

namespace thaw {
namespace {

std::string at(const SourcePlace& where) {
  return where.line > 0 && where.file.rfind("--set", 0) != 0
             ? fmt::format("{}:{}:{}", where.file, where.line, where.column)
             : where.file;
}

/// Returns whether a body is neither a curve nor points in one plane y = constant.
bool isNotPlanar(const OrientedBody& b) {
  if (b.source == OrientedSource::Curve) return false;
  if (b.source != OrientedSource::Points) return true;
  return std::any_of(b.points.begin(), b.points.end(),
                     [&](const Vec3d& x) { return x.y != b.points.front().y; });
}

/// Warns of unused materials. A misspelt name in --set creates one.
void addUnusedMaterials(const Scene& s, std::vector<std::string>& lines) {
  std::set<int> used;
  std::set<std::string> names;
  for (const Body& b : s.bodies) used.insert(b.material);
  for (const Emitter& e : s.emitters) used.insert(e.material);
  for (int k : used) names.insert(s.materials[static_cast<std::size_t>(k)].name);
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (!used.count(static_cast<int>(k)))
      lines.push_back(fmt::format("{}: material '{}' is used by no body and no emitter{}",
                                  at(s.materials[k].where), s.materials[k].name,
                                  suggestion(s.materials[k].name, names)));
}

/// Warns of temperatures that are probably degrees Celsius without their unit.
void addColdTemperatures(const Scene& s, std::vector<std::string>& lines) {
  constexpr double likely = 100;
  const auto look = [&](const SourcePlace& where, const std::string& what, double kelvin) {
    if (kelvin < likely)
      lines.push_back(
          fmt::format("{}: {} is {:g} K; a temperature without a unit is in kelvin; write degrees Celsius as "
                      "\"{:g} degC\"",
                      at(where), what, kelvin, kelvin));
  };
  for (const Material& m : s.materials)
    if (m.melts()) look(m.where, "material '" + m.name + "': its solidus", m.solidus);
  for (const Body& b : s.bodies) look(b.where, "body '" + b.name + "': its temperature", b.temperature);
  for (const Emitter& e : s.emitters)
    look(e.where, "emitter '" + e.name + "': its temperature", e.temperature);
  for (const Obstacle& o : s.obstacles)
    if (o.temperature) look(o.where, "obstacle '" + o.name + "': its temperature", *o.temperature);
}

/// Warns of tables of surface tension: surfaces at rest suppress the flow that the table drives.
void addSlowSurfaceFlow(const Scene& s, std::vector<std::string>& lines) {
  if (s.numerics.tension == TensionForm::Curvature) return;
  for (const Material& m : s.materials)
    if (!m.surfaceTensionTable.empty())
      lines.push_back(fmt::format(
          "{}: material '{}': flow driven by gradients of surface tension (Marangoni) is far too slow with "
          "numerics.tension = \"surface energy\", but not with \"curvature\"; see "
          "docs/validation/limitations.md",
          at(m.where), m.name));
}

/// Warns of evaporation that takes heat at any temperature.
void addEndlessCooling(const Scene& s, std::vector<std::string>& lines) {
  for (const Material& m : s.materials)
    if (m.evaporationHeat > 0 && !m.evaporation.empty() && m.evaporation.front().second > 0)
      lines.push_back(
          fmt::format("{}: material '{}': cold liquid evaporates, too, and cools towards 0 K; give "
                      "`evaporation` as a table "
                      "that begins with a rate of 0",
                      at(m.where), m.name));
}

/// Warns of materials that melt in a scene without any heat.
void addMaterialsWithoutHeat(const Scene& s, std::vector<std::string>& lines) {
  if (s.numerics.heat == HeatModel::Paper) return;
  for (const Extension* term : modelTerms())
    for (const TermTable& table : term->model->tables)
      if (term->heats && table.size(s) > 0) return;
  for (const Material& m : s.materials)
    if (m.melts() && m.conductivity.solid == 0 && m.conductivity.liquid == 0 && m.convection == 0 &&
        m.emissivity == 0 && m.heatSource == 0)
      lines.push_back(
          fmt::format("{}: material '{}' melts, but nothing changes its temperature: set `conductivity`, "
                      "`convection`, `emissivity` or `heat_source`",
                      at(m.where), m.name));
}

/// Warns of solids that the pressure of the liquid around them would crush.
void addCrushedSolids(const Scene& s, std::vector<std::string>& lines) {
  double liquid = 0;  // kg/m^3
  for (const Body& b : s.bodies)
    if (!solidAtStart(s, b))
      liquid = std::max(liquid, s.materials[static_cast<std::size_t>(b.material)].density);
  const double height = std::min(s.fallHeight, length(s.domain.max - s.domain.min)),
               pressure = liquid * length(s.domain.gravity) * height;
  for (const Material& m : s.materials) {
    if (!m.canBeSolid() || m.isRigid()) continue;
    const double modulus = m.young.solid / (3 * (1 - 2 * m.poisson.solid)) + m.volumeStiffness;
    if (modulus < 2 * pressure)
      lines.push_back(
          fmt::format("{}: material '{}' has a bulk modulus of {:.3g} Pa, and the pressure of liquids in "
                      "this scene can be "
                      "{:.3g} Pa: this may crush the solid and stop the run. Use a larger `young`, or a "
                      "`poisson` closer to 0.5",
                      at(m.where), m.name, modulus, pressure));
  }
}

/// Warns of settings of sleep and rigid motion without effect, and of rigid laws of liquids.
void addUnusedSolidSettings(const Scene& s, std::vector<std::string>& lines) {
  const Numerics& n = s.numerics;
  const auto neverSolid = [](const Material& m) {
    return !m.canBeSolid() || (!m.melts() && m.liquidAtStart);
  };
  const bool solid = !std::all_of(s.materials.begin(), s.materials.end(), neverSolid);
  const auto warn = [&](bool is, const char* key, const char* why) {
    if (is) lines.push_back(fmt::format("{}: `numerics.{}` has no effect {}", s.file, key, why));
  };
  constexpr const char* liquid = "in a scene without solids";
  warn(n.sleepSpeed > 0 && !solid, "sleep_speed", liquid);
  warn(n.rigidify > 0 && !solid, "rigidify", liquid);
  warn(n.sleepAfter != Numerics().sleepAfter && !(n.sleepSpeed > 0 || n.rigidify > 0), "sleep_after",
       "without `sleep_speed` or `rigidify`");
  warn(n.sleepHeating != Numerics().sleepHeating && !(n.sleepSpeed > 0), "sleep_heating",
       "without `sleep_speed`");
  for (const Material& m : s.materials)
    if (m.isRigid() && neverSolid(m))
      lines.push_back(
          fmt::format("{}: material '{}': `law = \"rigid\"` has no effect with `phase = \"liquid\"`",
                      at(m.where), m.name));
}

/// Warns of pairs of materials that weld, but not to each other.
void addUnjoinedSolids(const Scene& s, std::vector<std::string>& lines) {
  for (const Material& rigid : s.materials)
    for (const Material& other : s.materials)
      if (rigid.isRigid() && rigid.weldTemperature < never && other.weld)
        lines.push_back(fmt::format(
            "{}: material '{}': `weld_temperature` joins its rigid pieces to each other only, not "
            "to elastic solids of '{}', whose `weld` joins elastic solids only",
            at(rigid.where), rigid.name, other.name));
}

/// Warns of drops in pictures of a scene without a surface.
void addUnusedSpray(const Scene& s, std::vector<std::string>& lines) {
  if (!s.surface.on && s.output.spray != Output().spray)
    lines.push_back(fmt::format("{}: `output.spray` has no effect without a table [surface]", s.file));
}

/// Warns of an interval of frames longer than the run.
void addRareFrames(const Scene& s, std::vector<std::string>& lines) {
  if (s.end > 0 && s.output.every > s.end)
    lines.push_back(
        fmt::format("{}: `output.every` ({:g} s) exceeds `end` ({:g} s): the only frame is the first", s.file,
                    s.output.every, s.end));
}

/// Warns of a subtracted weight if the liquid may have a free surface.
void addWeightlessLiquid(const Scene& s, std::vector<std::string>& lines) {
  if (s.numerics.buoyancy == Buoyancy::Boussinesq && !liquidFillsClosedDomain(s))
    lines.push_back(fmt::format(
        "{}: `numerics.buoyancy = \"boussinesq\"` leaves out the weight, and the scene is not one box of "
        "liquid in a closed domain: a free surface or a falling body would be weightless; use \"density\" "
        "to keep the weight",
        s.file));
}

/// Warns of a mean buoyancy that nothing balances.
void addUnbalancedBuoyancy(const Scene& s, std::vector<std::string>& lines) {
  if (s.numerics.buoyancy != Buoyancy::Boussinesq || !s.obstacles.empty()) return;
  for (int a = 0; a < 3; a++)
    if (s.domain.side[a][0] == Side::Periodic && s.domain.gravity[a] + s.domain.buoyantGravity[a] != 0)
      lines.push_back(fmt::format(
          "{}: the domain is periodic along gravity, so nothing balances the mean buoyancy: all liquid "
          "accelerates, unless its mean temperature is half-way between the lowest and the highest",
          s.file));
}

}  // namespace

std::string warningLine(const SourcePlace& where, const std::string& text) {
  return at(where) + ": " + withPaths(text);
}

std::string unusedEventLine(const OrientedBody& b, const OrientedEvent& e) {
  const char* what = e.kind == OrientedEventKind::Weld
                         ? "weld has no effect: no particles of the two bodies are near each other"
                     : e.kind == OrientedEventKind::Cut
                         ? "cut has no effect: all particles within its reach are on one side of it"
                     : e.kind == OrientedEventKind::Crease
                         ? "crease has no effect: no particle is near its line"
                         : "smoothing has no effect: no particle in its region is creased";
  return warningLine(e.where, fmt::format("oriented body '{}': this {}", b.name, what));
}

std::string unusedFieldLine(const OrientedBody& b, const OrientedField& f) {
  return warningLine(
      f.where, fmt::format("oriented body '{}': no particle is in this field as it begins, at {:g} s", b.name,
                           f.from));
}

std::string interpenetrationLine(const OrientedBody& b, const Body& body, std::int64_t count, double time) {
  return warningLine(
      b.where, fmt::format("oriented body '{}': {} of its particles {} inside body '{}' at {:.6g} s: contact "
                           "did not keep them out, or '{}' passes through it; a larger `contact` is stiffer",
                           b.name, count, count == 1 ? "is" : "are", body.name, time, body.name));
}

std::string interpenetrationLine(const OrientedBody& b, const Obstacle& obstacle, std::int64_t count,
                                 double time) {
  return warningLine(
      b.where,
      fmt::format("oriented body '{}': {} of its particles {} inside obstacle '{}' at {:.6g} s: they began "
                  "there, or a force into it exceeds the contact force; a larger `contact` is stiffer",
                  b.name, count, count == 1 ? "is" : "are", obstacle.name, time));
}

std::vector<std::string> sceneWarnings(const Scene& s) {
  std::vector<std::string> lines;
  for (const OrientedBody& b : s.oriented)
    if (b.planar && isNotPlanar(b))
      lines.push_back(
          fmt::format("{}: oriented body '{}': `planar` keeps each particle at its own y, but this body is "
                      "not in one plane y = constant; it is meant for curves",
                      at(b.where), b.name));
  for (const OrientedBody& b : s.oriented)
    for (const OrientedField& f : b.fields)
      if (f.from >= s.end)
        lines.push_back(
            fmt::format("{}: oriented body '{}': this field begins at {:g} s, but the scene ends at {:g} s: "
                        "it has no effect",
                        at(f.where), b.name, f.from, s.end));
  for (const OrientedBody& b : s.oriented)
    for (const OrientedEvent& e : b.events)
      if (e.time > s.end)
        lines.push_back(fmt::format(
            "{}: oriented body '{}': this event is at {:g} s, but the scene ends at {:g} s: it has no effect",
            at(e.where), b.name, e.time, s.end));
  if (s.output.fieldsWhere.line > 0 && !hasContinuum(s)) {
    std::string names;
    for (const std::string& name : s.output.fields) names += (names.empty() ? "" : ", ") + name;
    lines.push_back(fmt::format(
        "{}: `output.fields` ({}) apply to bodies and emitters, and the scene has none; frames of "
        "oriented bodies and sheets have all their fields",
        at(s.output.fieldsWhere), names));
  }
  const auto& fields = s.output.fields;
  if (!s.surface.on && std::find(fields.begin(), fields.end(), surfaceVelocityField) != fields.end())
    lines.push_back(fmt::format("{}: `output.fields`: {} has no effect without a table [surface]",
                                at(s.output.fieldsWhere), surfaceVelocityField));
  addRareFrames(s, lines);
  addUnusedSolidSettings(s, lines);
  addUnjoinedSolids(s, lines);
  addUnusedSpray(s, lines);
  addUnusedMaterials(s, lines);
  addColdTemperatures(s, lines);
  addMaterialsWithoutHeat(s, lines);
  addCrushedSolids(s, lines);
  addWeightlessLiquid(s, lines);
  addUnbalancedBuoyancy(s, lines);
  addEndlessCooling(s, lines);
  addSlowSurfaceFlow(s, lines);
  for (const std::string& line : surfaceAdvice(s)) lines.push_back(line);
  return lines;
}

}  // namespace thaw
