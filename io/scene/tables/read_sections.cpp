// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_sections.hpp"

#include "core/domain/extensions.hpp"
#include "core/scene/quality.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {

void readInTime(TableReader& r, const char* key, FactorInTime& f, const char* about, const Range& factor) {
  r.node(key, "", "list of pairs [time, factor]", about);
  if (!r.describing()) r.pairs({key, "s", "", notNegative(), factor}, f.points);
}

namespace {

/// Records which choices of [numerics] the scene leaves open.
void noteOpenChoices(const TableReader& numerics, OpenChoices& open) {
  open.density = !numerics.has("density");
  open.tensileLimit = !numerics.has("tensile_limit");
  open.shifting = !numerics.has("shifting");
  open.viscosityCorrection = !numerics.has("viscosity_correction");
}

/// Reads the keys that the extension of that name has declared.
void readExtension(const std::string& name, TableReader& r, std::vector<ExtensionSettings>& all) {
  if (r.describing()) return;
  const Extension* e = findExtension(name);
  if (!e) {
    std::string known;
    for (const std::string& other : extensionNames()) known += (known.empty() ? "" : ", ") + other;
    return r.fail(r.place(), r.path() + ": this program has no such extension" +
                                 (known.empty() ? "" : "; it has " + known));
  }
  ExtensionSettings settings{name, {}};
  for (const ExtensionKey& key : e->keys) {
    double value = key.standard;
    r.number(key.name.c_str(), value, key.unit.c_str(), between(key.least, key.most), key.about.c_str());
    settings.values[key.name] = value;
  }
  all.push_back(std::move(settings));
}

void readExtensions(TableReader& top, std::vector<ExtensionSettings>& all) {
  top.namedTables("extension",
                  "forces and sources of heat that a program has registered; `thaw` itself has none",
                  [&](const std::string& name, TableReader& r) { readExtension(name, r, all); });
}

}  // namespace

void readSections(TableReader& top, SceneReading& x) {
  Scene& s = *x.scene;
  top.text("title", s.title, "one line for pictures and listings, which show about 100 characters of it");
  if (s.title.find_first_of("\n\r") != std::string::npos)
    top.fail("title", "expected one line, got a text of several");
  top.number("spacing", s.spacing, "m", positive(), "distance of particles, which sets the resolution");
  top.number("end", s.end, "s", notNegative(), "simulated time");
  top.choice("quality", s.quality, {"preview", "standard", "reference"},
             "defaults of [numerics]: fast (summed densities: stretched liquid falls apart), balanced, or "
             "most accurate (docs/validation/accuracy.md); explicit keys take precedence");
  applyQuality(s.quality, s.numerics);
  std::int64_t seed = static_cast<std::int64_t>(s.seed);
  top.whole("seed", seed, 0, INT64_MAX, "seed of all random numbers");
  s.seed = static_cast<std::uint64_t>(seed);
  // Includes are merged before tables are read. Only the description is here.
  top.node("include", "", "path or list of paths",
           "scene files to start from, relative to this one; keys of this file take precedence, and its "
           "bodies, emitters and obstacles are added");
  top.table("domain", "the simulated box", [&](TableReader& r) {
    x.domain = r.place();
    readDomain(r, s.domain);
  });
  x.spacing = top.placeOf("spacing");
  top.table("numerics", "numerical method", [&](TableReader& r) {
    readNumerics(r, s.numerics);
    noteOpenChoices(r, x.open);
    if (s.numerics.fixedStep > s.end)
      r.fail("fixed_step", "must not be longer than the simulated time (end)");
  });
  top.namedTables(
      "material", "materials of bodies and emitters", [&](const std::string& name, TableReader& r) {
        Material m;
        m.name = name;
        applyQuality(s.quality, m);
        readMaterial(r, m);
        if (!r.describing() && s.numerics.heat == HeatModel::Paper && m.melts() && !(m.liquidus > m.solidus))
          r.fail("melts", "with numerics.heat = \"paper\" solidus and liquidus must differ");
        x.open.artificialViscosity.push_back(!r.has("artificial_viscosity"));
        s.materials.push_back(std::move(m));
      });
  x.materials = !top.refused("material");
  top.tables("body", "a body of solid or liquid particles", [&](TableReader& r) { readBody(r, x); });
  top.tables("oriented", "a surface of oriented particles (Szeliski & Tonnesen 1992)",
             [&](TableReader& r) { readOriented(r, x); });
  top.tables("sheet", "a sheet whose vertices are exact damped springs",
             [&](TableReader& r) { readSheet(r, x); });
  top.tables("emitter", "an opening that emits particles", [&](TableReader& r) { readEmitter(r, x); });
  top.tables("obstacle", "a rigid object that particles cannot enter; [[wall]] means the same",
             [&](TableReader& r) { readObstacle(r, x); });
  top.tables("tempering", "brings particles to a temperature, regardless of position",
             [&](TableReader& r) { readTempering(r, x); });
  if (top.describing()) {
    top.table("SHAPE", "keys of bodies, obstacles and clamps; not a table of its own",
              [](TableReader& r) { describeShape(r); });
  } else {
    top.tables("wall", "", [&](TableReader& r) { readObstacle(r, x); });
  }
  readExtensions(top, s.extensions);
  top.table(
      "surface",
      "surfels on the continuum bodies (Keiser et al. 2005, section 4); without this table there are none",
      [&](TableReader& r) {
        s.surface.on = !r.describing();
        readSurface(r, s.surface);
      });
  top.table("output", "frames, checkpoints, pictures", [&](TableReader& r) {
    readOutput(r, s.output);
    if (s.end / s.output.every > 1e7) r.fail("every", "there would be more than ten million frames");
  });
}

}  // namespace thaw
