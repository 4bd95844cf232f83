// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {
namespace {

/// Reads the keys of all heat sources.
template<class Source> void readTimes(TableReader& r, Source& s) {
  r.number("start", s.start, "s", notNegative(), "time at which it is switched on");
  r.number("end", s.end, "s", orNever(notNegative()), "time at which it is switched off");
  readMotion(r, "keyframes; the pose is linear in between, and constant before the first and after the last",
             s.motion);
}

/// Checks the rules of all heat sources, and names those without a name.
template<class Source>
void checkSource(TableReader& r, Source& s, const char* kind, const std::vector<Source>& before) {
  if (!r.reading()) return;
  if (s.end < s.start) r.fail("end", "must not be before `start`", {"start"});
  if (s.name.empty()) s.name = kind + (" " + std::to_string(before.size()));
}

void require(TableReader& r, const char* key) {
  if (!r.has(key)) r.fail(key, "is missing");
}

void readDirection(TableReader& r, Vec3d& direction, const char* about) {
  r.vector("direction", direction, "", about);
  if (r.reading() && length(direction) == 0) r.fail("direction", "must not be zero: expected a direction");
}

/// Refuses keys that the lamp's kind does not have. Requires those that it needs.
void checkLamp(TableReader& r, const Lamp& lamp) {
  const bool direction = lamp.kind == LampKind::Direction, area = lamp.kind == LampKind::Area;
  require(r, direction ? "irradiance" : "power");
  if (!direction) require(r, "position");
  if (lamp.kind != LampKind::Point) require(r, "direction");
  const auto refuse = [&](const char* key, bool is, const char* why) {
    if (is && r.has(key)) r.fail(key, why, {"kind"});
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

}  // namespace

void readLamp(TableReader& r, Lamp& l, SceneReading& x) {
  r.restart(Restart::Setting);
  r.as(Restart::Free).text("name", l.name, "for messages and `--set`; none: \"lamp\" and its number");
  r.choice("kind", l.kind, {"point", "direction", "area"},
           "point: shines equally in all directions. direction: parallel light, such as sunlight. area: a "
           "rectangle that shines to one side by Lambert's law");
  r.needed().number("power", l.power, "W", positive(), "emitted power of kinds \"point\" and \"area\"");
  r.needed().number("irradiance", l.irradiance, "W/m^2", positive(),
                    "power per area perpendicular to the light, of kind \"direction\"");
  r.needed().vector("position", l.position, "m",
                    "position of a lamp of kind \"point\", centre of one of kind \"area\"");
  r.needed();
  readDirection(r, l.direction,
                "direction of the light of kind \"direction\", normal of kind \"area\"; any length but 0");
  r.number("width", l.width, "m", positive(), "horizontal edge of an area; along x if it shines along z");
  r.number("depth", l.depth, "m", positive(), "other edge of an area");
  readTimes(r, l);
  if (r.reading()) checkLamp(r, l);
  checkSource(r, l, "lamp", x.scene->lamps);
}

void readLaser(TableReader& r, Laser& l, SceneReading& x) {
  r.restart(Restart::Setting);
  r.as(Restart::Free).text("name", l.name, "for messages and `--set`; none: \"laser\" and its number");
  r.needed().number("power", l.power, "W", positive(), "power of the beam");
  r.needed().number("radius", l.radius, "m", positive(),
                    "radius of the beam, where its intensity is 1/e^2 (13.5 %) of that on the axis");
  r.needed().vector("position", l.position, "m",
                    "a point on the axis of the beam, such as where it meets the body");
  readDirection(r, l.direction, "direction of the light; any length but 0");
  r.number("absorption_depth", l.absorptionDepth, "m", notNegative(),
           "depth below the exposed surface at which the absorbed light has fallen to 1/e (Beer and "
           "Lambert); 0: absorption at the surface");
  readTimes(r, l);
  if (r.reading())
    for (const char* key : {"power", "radius", "position"}) require(r, key);
  checkSource(r, l, "laser", x.scene->lasers);
}

void readHeatedRegion(TableReader& r, HeatedRegion& h, SceneReading& x) {
  r.restart(Restart::Setting);
  r.as(Restart::Free)
      .text("name", h.name, "for messages and `--set`; none: \"heated region\" and its number");
  readShape(r, h.shape);
  r.needed().number("power", h.power, "W", positive(),
                    "power that the particles inside receive in proportion to their mass");
  readMaterialName(r, x, h.material, x.regionMaterials, "material that it heats; none: all");
  readTimes(r, h);
  if (r.reading()) require(r, "power");
  checkSource(r, h, "heated region", x.scene->heatedRegions);
}

}  // namespace thaw
