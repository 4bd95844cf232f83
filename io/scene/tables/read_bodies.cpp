// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_sections.hpp"

#include "io/scene/tables/read_fields.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {

void readBody(TableReader& r, SceneReading& x) {
  Body b;
  b.where = r.place();
  std::string material;
  r.text("name", b.name, "for messages and `--set`; none: \"body\" and its number");
  readShape(r, b.shape);
  r.text("material", material, "material of the body; required", "name of a material");
  readVelocity(r, b.velocity, b.velocityField,
               "velocity at the start: three numbers, or a table of x, y, z with expressions of position, as "
               "{ x = \"-100*x\", y = \"100*y\" } (default 0)");
  readVelocityGradient(r, b.velocityField,
                       "velocity gradient about the middle of the bounding box, added to the velocity; row i "
                       "has the derivatives of component i");
  r.vector("spin", b.spin, "rad/s", "angular velocity about the middle of the bounding box");
  readTemperature(
      r, b.temperature, b.temperatureField,
      "temperature at the start; the value of an expression of position, as \"300 + 20*z\", is in K");
  r.vector("temperature_gradient", b.temperatureGradient, "K/m",
           "temperature gradient about the middle of the bounding box, added to the temperature");
  r.choice("packing", b.packing, {"lattice", "relaxed"},
           "arrangement of its particles: a cubic lattice, or jittered and relaxed (the default if liquid "
           "fills a periodic box)");
  x.open.packing = !r.has("packing");  // used for a single body only
  if (r.describing()) {
    r.node("clamp", "", "list of tables with a SHAPE each",
           "particles in one of these at the start are fixed");
    return;
  }
  r.tables("clamp", "", [&](TableReader& c) {
    b.clamp.emplace_back();
    readShape(c, b.clamp.back());
  });
  if (b.name.empty()) b.name = "body " + std::to_string(x.scene->bodies.size());
  if (b.shape.kind == ShapeKind::HalfSpace)
    r.fail("plane", "a body must be bounded on all sides; use the plane in an intersection");
  x.scene->bodies.push_back(std::move(b));
  x.bodyMaterials.push_back({material, r.placeOf("material"), r.refused("material")});
}

void readEmitter(TableReader& r, SceneReading& x) {
  Emitter e;
  e.where = r.place();
  std::string material;
  r.text("name", e.name, "for messages and `--set`; none: \"emitter\" and its number");
  r.text("material", material, "material of the emitted particles; required", "name of a material");
  if (r.has("disc") && r.has("rectangle")) r.fail("rectangle", "an emitter is a disc or a rectangle");
  r.table("disc", "round opening; the default",
          [&](TableReader& t) { t.number("radius", e.radius, "m", positive(), "radius"); });
  r.table("rectangle", "rectangular opening instead of a disc", [&](TableReader& t) {
    e.disc = false;
    t.number("width", e.width, "m", positive(), "first edge");
    t.number("depth", e.depth, "m", positive(), "second edge");
  });
  r.vector("centre", e.centre, "m", "middle of the opening");
  r.vector("direction", e.direction, "", "direction of the flow; any length but 0");
  r.number("speed", e.speed, "m/s", positive(), "speed of the flow");
  r.number("rate", e.rate, "kg/s", notNegative(), "mass flow; 0: the flow at this speed");
  readVelocityField(r, e.velocityField,
                    "velocity by position in the opening, added to the flow, as { x = \"-5*y\", y = \"5*x\" "
                    "} for a swirl; without a component along direction, since a layer leaves as a whole");
  readVelocityGradient(
      r, e.velocityField,
      "velocity gradient about the centre of the opening; row i has the derivatives of component i");
  readTemperature(r, e.temperature, e.temperatureField,
                  "temperature of emitted particles; the value of an expression of the position in the "
                  "opening, as \"300 + 20*z\", is in K");
  r.number("start", e.start, "s", notNegative(), "time at which it starts");
  r.number("end", e.end, "s", orNever(notNegative()), "time at which it ends");
  if (r.describing()) return;
  if (length(e.direction) == 0) r.fail("direction", "must not be zero");
  if (e.end < e.start) r.fail("end", "must not be before start", {"start"});
  if (e.name.empty()) e.name = "emitter " + std::to_string(x.scene->emitters.size());
  x.scene->emitters.push_back(std::move(e));
  x.emitterMaterials.push_back({material, r.placeOf("material"), r.refused("material")});
}

void readObstacle(TableReader& r, SceneReading& x) {
  Obstacle o;
  o.where = r.place();
  r.text("name", o.name, "for messages and `--set`; none: \"obstacle\" and its number");
  readShape(r, o.shape);
  r.number("temperature", o.temperature, "K", positive(), "temperature of its surface; none: insulating");
  r.number("conductance", o.conductance, "W/(m^2 K)", orNever(positive()),
           "heat conductance of the contact; \"never\": no resistance");
  r.number("friction", o.friction, "", between(0, 10),
           "Coulomb friction on solids; below its limit it is a drag of at most sqrt(young spacing m) per "
           "touching particle, so that solids creep on a slope, stiffer ones less");
  r.number("restitution", o.restitution, "", between(0, 1),
           "restitution of solids that hit it: the smaller of this and the material's counts, so above 0.5 "
           "set the material's as well");
  r.flag("slip", o.slip, "liquids slip along it freely; false: they stick");
  r.number("until", o.until, "s", orNever(notNegative()), "time at which it disappears");
  r.tables("motion", "keyframes; the pose is linear in between and stays after the last",
           [&](TableReader& k) {
             Keyframe f;
             k.number("time", f.time, "s", notNegative(), "time of the keyframe; must ascend");
             k.vector("move", f.move, "m", "displacement from its initial position");
             k.vector("rotate", f.rotate, "rad", "rotation about x, y, z through the origin");
             if (!o.motion.empty() && f.time <= o.motion.back().time)
               k.fail("time", "keyframes must ascend in time");
             o.motion.push_back(f);
           });
  if (r.describing()) return;
  if (o.conductance < never && !o.temperature)
    r.fail("conductance", "an obstacle without a temperature conducts no heat: set temperature, too",
           {"temperature"});
  if (o.name.empty()) o.name = "obstacle " + std::to_string(x.scene->obstacles.size());
  x.scene->obstacles.push_back(std::move(o));
}

void readTempering(TableReader& r, SceneReading& x) {
  Thermostat t;
  t.where = r.place();
  std::string material;
  r.text("material", material, "material that it acts on; none: all", "name of a material");
  r.number("temperature", t.temperature, "K", positive(), "temperature at the end");
  r.number("start", t.start, "s", notNegative(), "time at which it starts");
  r.number("over", t.over, "s", notNegative(), "duration; 0: one step");
  if (r.describing()) return;
  if (!r.has("temperature")) r.fail("temperature", "is missing");
  x.scene->thermostats.push_back(t);
  x.temperingMaterials.push_back({material, r.placeOf("material"), r.refused("material")});
}

}  // namespace thaw
