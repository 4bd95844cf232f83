// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_sections.hpp"

#include "core/scene/quality.hpp"
#include "core/terms/extensions.hpp"
#include "io/scene/tables/read_extension.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {

void readInTime(TableReader& r, const char* key, FactorInTime& f, const char* about, const Range& factor) {
  r.pairs({key, "s", "", notNegative(), factor, "list of pairs [time, factor]", about}, f.points);
}

void readMotion(TableReader& r, const char* about, std::vector<Keyframe>& motion, bool turns) {
  r.tables("motion", about, motion, [&](TableReader& k, Keyframe& f) {
    k.number("time", f.time, "s", notNegative(), "time of the keyframe; must ascend");
    k.vector("move", f.move, "m", "displacement from the position without `motion`");
    if (turns) k.vector("rotate", f.rotate, "rad", "rotation about x, y, z through the origin");
    if (k.reading() && !motion.empty() && f.time <= motion.back().time)
      k.fail("time", "keyframes must ascend in time: expected a time after that of the last one");
  });
}

namespace {

/// Notes which choices of [numerics] the scene leaves open.
void recordOpenChoices(const TableReader& numerics, OpenChoices& open) {
  open.density = !numerics.has("density");
  open.tensileLimit = !numerics.has("tensile_limit");
  open.shifting = !numerics.has("shifting");
  open.tension = !numerics.has("tension");
  open.viscosityCorrection = !numerics.has("viscosity_correction");
}

/// Refuses other names of tables, with the right one.
void refuseOtherNames(TableReader& top) {
  constexpr const char* names[][2] = {{"wall", "obstacle"}, {"tempering", "thermostat"}};
  for (const auto& [other, name] : names)
    if (top.reading() && top.has(other)) {
      top.node(other, "", "", "");
      top.fail(other, "unknown table: expected [[" + std::string(name) + "]]");
    }
}

}  // namespace

void readSections(TableReader& top, SceneReading& x) {
  Scene& s = *x.scene;
  top.as(Restart::Free)
      .text("title", s.title, "one line, of which pictures and listings show about 100 characters");
  if (s.title.find_first_of("\n\r") != std::string::npos)
    top.fail("title", "expected one line, got a text of several");
  top.as(Restart::State)
      .number("spacing", s.spacing, "m", positive(), "particle spacing, which sets the resolution");
  top.as(Restart::Free).number("end", s.end, "s", notNegative(), "simulated time");
  top.as(Restart::Free)
      .choice("quality", s.quality, {"preview", "standard", "reference"},
              "defaults of [numerics]: fast (summed densities: stretched liquid falls apart), balanced, or "
              "most accurate (docs/validation/accuracy.md); explicit keys take precedence");
  if (top.reading()) applyQuality(s.quality, s.numerics);
  std::int64_t seed = static_cast<std::int64_t>(s.seed);
  top.as(Restart::State).whole("seed", seed, 0, INT64_MAX, "seed of all random numbers");
  s.seed = static_cast<std::uint64_t>(seed);
  // Includes are merged before tables are read. Only the description is here.
  top.as(Restart::Free)
      .node("include", "", "path or list of paths",
            "scene files to start from, relative to this one; keys of this file take precedence, and its "
            "bodies, emitters and obstacles are added");
  top.table("domain", "the simulated box", [&](TableReader& r) {
    x.domain = r.place();
    readDomain(r, s.domain);
  });
  x.spacing = top.placeOf("spacing");
  top.table("numerics", "numerical method", [&](TableReader& r) {
    readNumerics(r, s.numerics);
    if (r.reading()) x.numerics = r.placesOfKeys();
    recordOpenChoices(r, x.open);
    if (s.numerics.fixedStep > s.end)
      r.fail("fixed_step", "must not be longer than the simulated time (`end`)");
  });
  const auto in = [&](auto read) {
    return [&x, read](TableReader& r, auto& element) { read(r, element, x); };
  };
  top.as(Restart::State)
      .namedTables("material", "materials of bodies and emitters", s.materials, in(readMaterial));
  x.materials = !top.refused("material");
  // Particles refer to their body and material by its place in the list.
  top.as(Restart::State).tables("body", "a body of solid or liquid particles", s.bodies, in(readBody));
  top.as(Restart::State)
      .tables("oriented", "a surface of oriented particles (Szeliski & Tonnesen 1992)", s.oriented,
              in(readOriented));
  top.as(Restart::State)
      .tables("sheet", "a sheet whose vertices are exact damped springs", s.sheets, in(readSheet));
  top.as(Restart::State).tables("emitter", "an opening that emits particles", s.emitters, in(readEmitter));
  top.tables("obstacle", "a rigid object that particles cannot enter", s.obstacles, in(readObstacle));
  readTermTables(top, x);
  refuseOtherNames(top);
  if (top.describing())
    top.table("SHAPE", "keys of bodies, obstacles and clamps; not a table of its own", describeShapes);
  top.as(Restart::State)
      .namedTables("extension",
                   "forces, sources of heat and fields that a program has registered; `thaw` itself has none",
                   s.extensions, in(readExtension));
  top.as(Restart::State)
      .table("surface",
             "surfels on the continuum bodies (Keiser et al. 2005, section 4); without this table there are "
             "none",
             s.surface.on, [&](TableReader& r) { readSurface(r, s.surface); });
  top.table("output", "frames, checkpoints, pictures", [&](TableReader& r) {
    readOutput(r, s);
    if (s.end / s.output.every > 1e7)
      r.fail("every", "more than ten million frames until `end`: expected a longer interval");
  });
}

std::vector<KeyDescription> sceneKeys() {
  std::vector<KeyDescription> keys;
  Scene s;
  SceneReading reading;
  reading.scene = &s;
  TableReader top("", keys, TableReader::Mode::Describing);
  readSections(top, reading);
  for (const std::string& name : extensionNames([](const Extension& e) { return e.usesTable(); })) {
    TableReader table("extension." + name, keys, TableReader::Mode::Describing);
    ExtensionSettings settings;
    settings.name = name;
    readExtension(table, settings, reading);
  }
  return keys;
}

std::vector<SceneError> valueErrors(Scene s) {
  ValueCheck check;
  std::vector<KeyDescription> keys;
  Scene standard;
  SceneReading reading;
  reading.scene = &standard;
  TableReader describing("", keys, TableReader::Mode::Describing);
  describing.checkBy(check);
  readSections(describing, reading);
  reading.scene = &s;
  TableReader recording("", keys, TableReader::Mode::Recording);
  recording.checkBy(check);
  readSections(recording, reading);
  return std::move(check.errors);
}

std::vector<KeyDescription> sceneValues(Scene s) {
  std::vector<KeyDescription> values;
  SceneReading reading;
  reading.scene = &s;
  TableReader top("", values, TableReader::Mode::Recording);
  readSections(top, reading);
  return values;
}

}  // namespace thaw
