// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_sections.hpp"

#include <numbers>

#include "core/scene/field_values.hpp"
#include "io/scene/tables/read_fields.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {

void readMaterialName(TableReader& r, const SceneReading& x, int place, std::vector<MaterialName>& names,
                      const char* about) {
  std::string name;
  if (r.recording() && place >= 0 && place < static_cast<int>(x.scene->materials.size()))
    name = x.scene->materials[static_cast<std::size_t>(place)].name;
  r.text("material", name, about, "name of a material");
  if (r.reading()) names.push_back({name, r.placeOf("material"), r.refused("material")});
}

void readBody(TableReader& r, Body& b, SceneReading& x) {
  r.as(Restart::Free).text("name", b.name, "for messages and `--set`; none: \"body\" and its number");
  r.restart(Restart::State);
  readShape(r, b.shape);
  r.needed();
  readMaterialName(r, x, b.material, x.bodyMaterials, "material of the body");
  r.restart(Restart::Start);
  readVelocity(r, b.velocity, b.velocityField,
               "velocity at the start. Three numbers, or a table of x, y, z with expressions of position, "
               "such as { x = \"-100*x\", y = \"100*y\" }; missing components are 0");
  readVelocityGradient(r, b.velocityField,
                       "velocity gradient about the middle of the bounding box, added to the velocity; row i "
                       "has the derivatives of component i");
  r.vector("spin", b.spin, "rad/s", "angular velocity about the middle of the bounding box");
  readTemperature(
      r, b.temperature, b.temperatureField,
      "temperature at the start; the value of an expression of position, such as \"300 + 20*z\", is in K");
  r.vector("temperature_gradient", b.temperatureGradient, "K/m",
           "temperature gradient about the middle of the bounding box, added to the temperature");
  r.restart(Restart::State);
  r.choice("packing", b.packing, {"lattice", "relaxed"},
           "arrangement of its particles. lattice: a cubic lattice. relaxed: jittered and relaxed; the "
           "default if liquid fills a periodic box");
  x.open.packing = !r.has("packing");  // used for a single body only
  readClamps(r, b.clamp, "particles in one of these at the start are fixed until they melt");
  if (!r.reading()) return;
  if (b.name.empty()) b.name = "body " + std::to_string(x.scene->bodies.size());
  if (b.shape.kind == ShapeKind::HalfSpace)
    r.fail("plane", "a body must be bounded on all sides; use the plane in an intersection");
}

void readEmitter(TableReader& r, Emitter& e, SceneReading& x) {
  r.as(Restart::Free).text("name", e.name, "for messages and `--set`; none: \"emitter\" and its number");
  // It numbers its particles by their count since its start, so its schedule is part of the state.
  r.restart(Restart::State);
  r.needed();
  readMaterialName(r, x, e.material, x.emitterMaterials, "material of the emitted particles");
  if (r.has("disc") && r.has("rectangle")) r.fail("rectangle", "give `disc` or `rectangle`, not both");
  r.table("disc", "round opening; the default", e.disc,
          [&](TableReader& t) { t.number("radius", e.radius, "m", positive(), "radius of the disc"); });
  r.table("rectangle", "rectangular opening instead of a disc", !e.disc, [&](TableReader& t) {
    e.disc = false;
    t.number("width", e.width, "m", positive(), "first edge");
    t.number("depth", e.depth, "m", positive(), "second edge");
  });
  r.vector("centre", e.centre, "m", "middle of the opening");
  r.vector("direction", e.direction, "", "direction of the flow; any length but 0");
  r.number("speed", e.speed, "m/s", {0, fastestStart, true, false, false}, "speed of the flow");
  r.number("rate", e.rate, "kg/s", notNegative(), "mass flow; 0: follows from `speed` and the opening");
  readVelocityField(
      r, e.velocityField,
      "velocity by position in the opening, added to the flow, such as { x = \"-5*y\", y = \"5*x\" } for a "
      "swirl. It has no component along `direction`, since a layer leaves as a whole");
  readVelocityGradient(
      r, e.velocityField,
      "velocity gradient about the centre of the opening; row i has the derivatives of component i");
  r.restart(Restart::Setting);
  readTemperature(r, e.temperature, e.temperatureField,
                  "temperature of emitted particles; the value of an expression of the position in the "
                  "opening, such as \"300 + 20*z\", is in K");
  r.as(Restart::State).number("start", e.start, "s", notNegative(), "time at which it starts");
  r.number("end", e.end, "s", orNever(notNegative()), "time at which it ends");
  if (!r.reading()) return;
  if (length(e.direction) == 0) r.fail("direction", "must not be zero: expected a direction");
  if (e.end < e.start) r.fail("end", "must not be before `start`", {"start"});
  if (e.name.empty()) e.name = "emitter " + std::to_string(x.scene->emitters.size());
}

void readObstacle(TableReader& r, Obstacle& o, SceneReading& x) {
  r.restart(Restart::Coefficient);
  r.as(Restart::Free).text("name", o.name, "for messages and `--set`; none: \"obstacle\" and its number");
  readShape(r, o.shape);
  r.number("temperature", o.temperature, "K", positive(), "temperature of its surface; none: insulating");
  r.number("conductance", o.conductance, "W/(m^2 K)", orNever(positive()),
           "heat conductance of the contact; \"never\": no resistance");
  r.number("friction", o.friction, "", between(0, 10),
           "Coulomb friction on solids. Solids on a slope hold, or slide once the slope is steeper than "
           "friction allows; materials that yield or melt creep");
  r.number("restitution", o.restitution, "", between(0, 1),
           "restitution of solids that hit it: the smaller of this and the material's applies, so set both "
           "for a value above 0.5");
  r.flag("slip", o.slip, "liquids slip along it freely; false: they stick");
  r.number("contact_angle", o.contactAngle, "rad", Range{0, std::numbers::pi, false, false, true},
           "contact angle of all liquids at it; \"never\": each liquid has the angle of its material");
  r.number("until", o.until, "s", orNever(notNegative()), "time at which it disappears");
  int look = static_cast<int>(o.look);
  r.as(Restart::Free)
      .choice("look", look, {"glass", "solid"},
              "look in pictures: glass with pale shadows, or solid in its colour; a plane is a floor");
  o.look = static_cast<ObstacleLook>(look);
  readColourKey(r, o.colour, "colour in exports and pictures; default: a pale grey, and clear for glass");
  readMotion(r, "keyframes; the pose is linear in between, and constant before the first and after the last",
             o.motion);
  if (!r.reading()) return;
  if (o.conductance < never && !o.temperature)
    r.fail("conductance", "an obstacle without a temperature conducts no heat: set `temperature`, too",
           {"temperature"});
  if (o.name.empty()) o.name = "obstacle " + std::to_string(x.scene->obstacles.size());
}

}  // namespace thaw
