// SPDX-License-Identifier: Apache-2.0
// Lamps and lasers. Both use the same map of lit positions.
#include <memory>

#include "core/heat/sources/heat_sources.hpp"
#include "core/terms/rows/source_keys.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readDirection(KeyTable& keys, Vec3d& direction, const char* about) {
  keys.vector("direction", direction, "", about);
  if (keys.reading() && length(direction) == 0)
    keys.fail("direction", "must not be zero: expected a direction");
}

/// Rejects keys that the lamp's kind does not have, and missing keys that it needs.
void checkLamp(KeyTable& keys, const Lamp& lamp) {
  const bool direction = lamp.kind == LampKind::Direction, area = lamp.kind == LampKind::Area;
  requireKey(keys, direction ? "irradiance" : "power");
  if (!direction) requireKey(keys, "position");
  if (lamp.kind != LampKind::Point) requireKey(keys, "direction");
  const auto refuse = [&](const char* key, bool is, const char* why) {
    if (is && keys.has(key)) keys.fail(key, why, {"kind"});
  };
  refuse("power", direction, "has no effect with `kind = \"direction\"`: set `irradiance` instead");
  refuse("irradiance", !direction, "applies to `kind = \"direction\"` only: set `power` instead");
  refuse("position", direction,
         "has no effect with `kind = \"direction\"`, which is infinitely far away: remove it");
  refuse("direction", lamp.kind == LampKind::Point,
         "has no effect with `kind = \"point\"`, which shines in all directions: remove it");
  for (const char* key : {"width", "depth"})
    refuse(key, !area, "applies to `kind = \"area\"` only: remove it, or set this kind");
}

void readLamp(KeyTable& keys, Lamp& l) {
  keys.restart(Restart::Setting);
  keys.name(l.name);
  int kind = static_cast<int>(l.kind);
  keys.choice("kind", kind, {"point", "direction", "area"},
              "point: shines equally in all directions. direction: parallel light, such as sunlight. area: a "
              "rectangle that shines to one side by Lambert's law");
  l.kind = static_cast<LampKind>(kind);
  keys.needed().number("power", l.power, "W", positive(), "emitted power of kinds \"point\" and \"area\"");
  keys.needed().number("irradiance", l.irradiance, "W/m^2", positive(),
                       "power per area perpendicular to the light, of kind \"direction\"");
  keys.needed().vector("position", l.position, "m",
                       "position of a lamp of kind \"point\", centre of one of kind \"area\"");
  keys.needed();
  readDirection(keys, l.direction,
                "direction of the light of kind \"direction\", normal of kind \"area\"; any length but 0");
  keys.number("width", l.width, "m", positive(), "horizontal edge of an area; along x if it shines along z");
  keys.number("depth", l.depth, "m", positive(), "other edge of an area");
  readTimes(keys, l);
  if (keys.reading()) checkLamp(keys, l);
}

void readLaser(KeyTable& keys, Laser& l) {
  keys.restart(Restart::Setting);
  keys.name(l.name);
  keys.needed().number("power", l.power, "W", positive(), "power of the beam");
  keys.needed().number("radius", l.radius, "m", positive(),
                       "radius of the beam, where its intensity is 1/e^2 (13.5 %) of that on the axis");
  keys.needed().vector("position", l.position, "m",
                       "a point on the axis of the beam, such as where it meets the body");
  readDirection(keys, l.direction, "direction of the light; any length but 0");
  keys.number("absorption_depth", l.absorptionDepth, "m", notNegative(),
              "depth below the exposed surface at which the absorbed light has fallen to 1/e (Beer and "
              "Lambert); 0: absorption at the surface");
  readTimes(keys, l);
  for (const char* key : {"power", "radius", "position"}) requireKey(keys, key);
}

void readAbsorptivity(KeyTable& keys, Material& m) {
  keys.number("absorptivity", m.absorptivity, "", between(0, 1),
              "fraction of the light of lamps and lasers that the material absorbs; it reflects the rest");
}

std::vector<ModuleUse> usesOfLight(const Scene& s) {
  std::vector<ModuleUse> all;
  addUses(s, s.lamps, "lamp", all);
  addUses(s, s.lasers, "laser", all);
  return all;
}

OutsideSource startLight(const TermSetup&) {
  return [work = std::make_shared<LightWork>()](const OutsideLoad& load) {
    addLight({load.run, load.walls, *work}, load.dt, load.all);
  };
}

}  // namespace

Extension lightTerm() {
  return {.name = "lamps and lasers",
          .about = "light that exposed particles absorb",
          .heats = true,
          .model = ModelPart{
              .tables =
                  {termTable<&Scene::lamps, readLamp>(
                       "lamp", "lamp",
                       "light that exposed particles absorb: from a point, in a direction, or from an area"),
                   termTable<&Scene::lasers, readLaser>("laser", "laser", "beam with a Gaussian profile")},
              .materialKeys = readAbsorptivity,
              .modules = {{&Modules::lamps, "heat sources"}},
              .earlyUses = usesOfLight,
              .stage = LoadStage::Sources,
              .start = startLight,
              .limits = {"heat"},
              .stepLimit = lightStepLimit,
              .energies = {"lamps_given_J", "lamps_absorbed_J", "lamps_reflected_J", "lasers_given_J",
                           "lasers_absorbed_J", "lasers_reflected_J", "heat_in_J"}}};
}

}  // namespace thaw
