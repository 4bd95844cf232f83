#include "io/scene/read_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "io/scene/read_shape.hpp"

namespace thaw {
namespace {

void readMaterial(TableReader& r, Material& m) {
  if (!r.describing()) m.where = r.place();
  r.number("density", m.density, "kg/m^3", positive(), "at rest");
  r.blend("viscosity", m.viscosity, "Pa s", notNegative(), true, "of the liquid; with a solid value it changes with the liquid fraction");
  r.pairs("viscosity_table", m.viscosityTable, "K", "Pa s", positive(), "viscosity by temperature, logarithmic in between; in place of viscosity");
  r.number("surface_tension", m.surfaceTension, "N/m", notNegative(), "of the liquid");
  r.number("sound_speed", m.soundSpeed, "m/s", notNegative(), "of the equation of state; 0: from the speeds that the scene can reach");
  r.number("xsph", m.xsph, "", between(0, 1), "smoothing of the velocity with which liquid moves (XSPH)");
  r.number("artificial_viscosity", m.artificialViscosity, "", between(0, 10), "Monaghan's alpha, of approaching pairs");
  r.blend("young", m.young, "Pa", notNegative(), false, "Young's modulus; above 0 the material can be solid. Liquid value: 0");
  r.blend("poisson", m.poisson, "", Range{-1, 0.5, true, true}, true, "Poisson's ratio");
  r.choice("law", m.law, {"green", "neo-hookean", "corotated"}, "elastic energy: Green strain with Hooke's law (the papers'), Neo-Hookean, corotated");
  r.blend("yield_strain", m.yieldStrain, "", positive(), true, "norm of the deviator of the elastic strain above which it flows (gamma_yield); \"never\": not plastic");
  r.blend("creep_rate", m.creepRate, "1/s", notNegative(), true, "rate of plastic flow (gamma_creep); \"never\": at once");
  r.number("max_plastic_strain", m.maxPlasticStrain, "", positive(), "largest norm of plastic strain (gamma_max)");
  r.number("volume_stiffness", m.volumeStiffness, "Pa", notNegative(), "k_v of the volume force");
  r.number("hourglass", m.hourglass, "", between(0, 10), "strength of the control of zero-energy modes");
  r.number("break_stretch", m.breakStretch, "", Range{1, never, true, false}, "a bond longer than this times its rest length breaks; \"never\"");
  r.number("damping", m.damping, "1/s", notNegative(), "rate at which velocity differences of bonded particles decay");
  r.flag("weld", m.weld, "solids of this material that touch after freezing grow together");
  r.number("friction", m.friction, "", between(0, 10), "Coulomb friction between separate solids");
  r.number("restitution", m.restitution, "", between(0, 1), "coefficient of restitution of contacts");
  r.blend("conductivity", m.conductivity, "W/(m K)", notNegative(), true, "heat conductivity");
  r.blend("heat_capacity", m.heatCapacity, "J/(kg K)", positive(), true, "heat capacity");
  r.number("latent_heat", m.latentHeat, "J/kg", notNegative(), "of melting");
  if (const toml::node* n = r.node("melts", "temperature, or [solidus, liquidus]", "where it melts; without it, it does not")) {
    const toml::array* a = n->as_array();
    const Range T = Range{0, never, true, true};
    if (a && a->size() == 2) {
      if (r.quantity(*a->get(0), "melts", "K", T, m.solidus) && r.quantity(*a->get(1), "melts", "K", T, m.liquidus) && m.liquidus < m.solidus)
        r.fail("melts", "the liquidus (second) must not be below the solidus (first)");
    } else if (a) {
      r.fail("melts", "expected one temperature or [solidus, liquidus]");
    } else if (r.quantity(*n, "melts", "K", T, m.solidus)) {
      m.liquidus = m.solidus;
    }
  }
  r.number("hysteresis", m.hysteresis, "", Range{0, 0.5, false, true}, "freezes at this liquid fraction, melts at 1 minus it");
  r.number("heat_source", m.heatSource, "W/kg", anyNumber(), "heat made in the material");
  r.number("emissivity", m.emissivity, "", between(0, 1), "of free surfaces, radiation to domain.ambient");
  r.number("convection", m.convection, "W/(m^2 K)", notNegative(), "of free surfaces, to domain.ambient");
  r.number("paper_diffusivity", m.paperDiffusivity, "m^2/s", notNegative(), "k_heat of Keiser 2005, with numerics.heat = \"paper\"");
  int phase = m.liquidAtStart ? 1 : 0;
  r.choice("phase", phase, {"solid", "liquid"}, "of a material that has a Young's modulus and does not melt");
  m.liquidAtStart = phase == 1;
}

void readBody(TableReader& r, SceneReading& x) {
  Body b;
  b.where = r.place();
  std::string material;
  r.text("name", b.name, "for messages and outputs");
  readShape(r, b.shape, x.folder, !r.describing());
  r.text("material", material, "name of a material");
  r.vector("velocity", b.velocity, "m/s", "at the start");
  r.vector("spin", b.spin, "rad/s", "angular velocity about the middle of the bounding box");
  r.number("temperature", b.temperature, "K", Range{0, never, true, true}, "at the start");
  r.vector("temperature_gradient", b.temperatureGradient, "K/m", "added to the temperature from the middle of the bounding box");
  r.choice("packing", b.packing, {"lattice", "relaxed"}, "how the body is filled with particles");
  if (r.describing()) {
    r.node("clamp", "list of shapes", "particles in one of these at the start are held where they are");
  } else {
    r.tables("clamp", "", [&](TableReader& c) {
      b.clamp.emplace_back();
      readShape(c, b.clamp.back(), x.folder, true);
    });
  }
  if (r.describing()) return;
  if (b.name.empty()) b.name = "body " + std::to_string(x.scene->bodies.size());
  if (b.shape.kind == ShapeKind::HalfSpace) r.fail(b.where, "body '" + b.name + "': a plane has no end; use it in an intersection");
  x.scene->bodies.push_back(std::move(b));
  x.bodyMaterials.push_back({material, r.placeOf("material")});
}

void readEmitter(TableReader& r, SceneReading& x) {
  Emitter e;
  e.where = r.place();
  std::string material;
  r.text("name", e.name, "for messages and outputs");
  r.text("material", material, "name of a material");
  if (r.has("disc") && r.has("rectangle")) r.fail("rectangle", "an emitter is a disc or a rectangle");
  r.table("disc", "round opening", [&](TableReader& t) { t.number("radius", e.radius, "m", positive(), "radius"); });
  r.table("rectangle", "rectangular opening", [&](TableReader& t) {
    e.disc = false;
    t.number("width", e.width, "m", positive(), "first edge");
    t.number("depth", e.depth, "m", positive(), "second edge");
  });
  r.vector("centre", e.centre, "m", "middle of the opening");
  r.vector("direction", e.direction, "", "of the flow, of any length");
  r.number("speed", e.speed, "m/s", positive(), "of the flow");
  r.number("rate", e.rate, "kg/s", notNegative(), "mass flow; 0: as much as the speed lets through");
  r.number("temperature", e.temperature, "K", Range{0, never, true, true}, "of what comes out");
  r.number("start", e.start, "s", notNegative(), "begins");
  r.number("end", e.end, "s", notNegative(), "ends");
  if (r.describing()) return;
  if (length(e.direction) == 0) r.fail("direction", "must not be zero");
  if (e.name.empty()) e.name = "emitter " + std::to_string(x.scene->emitters.size());
  x.scene->emitters.push_back(std::move(e));
  x.emitterMaterials.push_back({material, r.placeOf("material")});
}

void readObstacle(TableReader& r, SceneReading& x) {
  Obstacle o;
  o.where = r.place();
  r.text("name", o.name, "for messages and outputs");
  readShape(r, o.shape, x.folder, !r.describing());
  r.number("temperature", o.temperature, "K", Range{0, never, true, true}, "of its surface; without one it is insulating");
  r.number("conductance", o.conductance, "W/(m^2 K)", positive(), "of the contact; \"never\": its surface passes heat without resistance");
  r.number("friction", o.friction, "", between(0, 10), "Coulomb friction on solids");
  r.number("restitution", o.restitution, "", between(0, 1), "of solids that hit it");
  r.flag("slip", o.slip, "liquids slide along it freely");
  r.number("until", o.until, "s", notNegative(), "disappears then");
  r.tables("motion", "keyframes; the pose is linear in between", [&](TableReader& k) {
    Keyframe f;
    k.number("time", f.time, "s", notNegative(), "of the keyframe");
    k.vector("move", f.move, "m", "away from the place at rest");
    k.vector("rotate", f.rotate, "rad", "about x, y, z through the origin");
    if (!k.describing() && !o.motion.empty() && f.time <= o.motion.back().time) k.fail("time", "keyframes must ascend in time");
    o.motion.push_back(f);
  });
  if (r.describing()) return;
  if (o.name.empty()) o.name = "obstacle " + std::to_string(x.scene->obstacles.size());
  x.scene->obstacles.push_back(std::move(o));
}

bool sideOf(const std::string& word, Side& side) {
  if (word == "open") side = Side::Open;
  else if (word == "wall") side = Side::Wall;
  else if (word == "periodic") side = Side::Periodic;
  else return false;
  return true;
}

void readDomain(TableReader& r, Domain& d) {
  r.vector("min", d.min, "m", "low corner");
  r.vector("max", d.max, "m", "high corner");
  r.vector("gravity", d.gravity, "m/s^2", "acceleration");
  r.number("ambient", d.ambient, "K", Range{0, never, true, true}, "temperature around, for convection and radiation");
  const char* about = "\"open\" (particles that leave are counted and booked), \"wall\" or \"periodic\"; one word or [low, high]";
  r.table("sides", "what the domain's sides are", [&](TableReader& s) {
    for (int a = 0; a < 3; a++) {
      const char key[2] = {static_cast<char>('x' + a), 0};
      auto& sides = d.side[static_cast<std::size_t>(a)];
      const toml::node* n = s.node(key, "word or pair of words", about);
      if (!n) continue;
      bool good = false;
      if (const auto* w = n->as_string()) good = sideOf(w->get(), sides[0]) && sideOf(w->get(), sides[1]);
      else if (const toml::array* p = n->as_array(); p && p->size() == 2 && p->get(0)->is_string() && p->get(1)->is_string())
        good = sideOf(p->get(0)->as_string()->get(), sides[0]) && sideOf(p->get(1)->as_string()->get(), sides[1]);
      if (!good) s.fail(key, "expected \"open\", \"wall\" or \"periodic\", or a pair of them such as [\"wall\", \"open\"]");
      if ((sides[0] == Side::Periodic) != (sides[1] == Side::Periodic)) s.fail(key, "both sides of an axis are periodic, or none");
    }
  });
  if (r.describing()) return;
  for (int a = 0; a < 3; a++)
    if (!(d.max[a] > d.min[a])) r.fail("max", fmt::format("must be above min along {}", static_cast<char>('x' + a)));
}

void readNumerics(TableReader& r, Numerics& n) {
  r.number("support", n.support, "", between(1.2, 6), "support radius of the kernel in spacings");
  r.choice("kernel", n.kernel, {"wendland", "mcg03", "cubic"}, "Wendland C2; poly6, spiky and viscosity kernel of Mueller et al. 2003; cubic spline");
  r.choice("precision", n.precision, {"single", "double"}, "of sums over pairs; the state is double");
  r.choice("pressure", n.pressure, {"consistent", "printed"}, "consistent pair form, or the sum as printed in Keiser 2005 (half the gradient)");
  r.choice("equation_of_state", n.eos, {"linear", "tait"}, "pressure by density");
  r.number("tensile_limit", n.tensileLimit, "", between(0, 1), "share of negative pressure that is kept");
  r.choice("viscosity", n.viscosity, {"pairwise", "laplacian"}, "along the line of two particles (keeps angular momentum), or as printed in Keiser 2005");
  r.choice("tension", n.tension, {"pairwise", "colour field"}, "cohesion of pairs, or as printed in Keiser 2005");
  r.choice("heat", n.heat, {"enthalpy", "paper"}, "enthalpy with latent heat, or Keiser 2005's plain temperature");
  r.flag("self_contact", n.selfContact, "pieces of one body collide with each other");
  r.number("max_density_error", n.maxDensityError, "", Range{0, 0.2, true, false}, "compression that the automatic sound speed allows");
  r.choice("overlap", n.overlap, {"error", "keep", "remove later", "remove earlier"}, "what happens to samples that lie in two bodies");
  r.number("fixed_step", n.fixedStep, "s", notNegative(), "time step; 0: as large as the limits allow");
  r.number("max_step", n.maxStep, "s", positive(), "largest time step");
  r.number("cfl_sound", n.cflSound, "", Range{0, 2, true, false}, "times h / c");
  r.number("cfl_viscous", n.cflViscous, "", Range{0, 2, true, false}, "times h^2 rho / mu");
  r.number("cfl_heat", n.cflHeat, "", Range{0, 2, true, false}, "times h^2 / diffusivity");
  r.number("cfl_elastic", n.cflElastic, "", Range{0, 2, true, false}, "times spacing / speed of pressure waves");
  r.number("cfl_tension", n.cflTension, "", Range{0, 2, true, false}, "times sqrt(rho h^3 / (2 pi sigma))");
  r.number("cfl_acceleration", n.cflAcceleration, "", Range{0, 2, true, false}, "times sqrt(h / a)");
  r.number("plastic_rereference", n.plasticRereference, "", positive(), "plastic strain above which the reference configuration follows the flow");
}

void readOutput(TableReader& r, Output& o) {
  r.number("every", o.every, "s", positive(), "simulated time between frames");
  r.texts("fields", o.fields, "fields of the frames");
  r.number("checkpoint", o.checkpoint, "s", positive(), "wall-clock time between checkpoints; the last two are kept");
  int pieces = o.piecesByRank ? 1 : 0;
  r.choice("pieces", pieces, {"one", "ranks"}, "parts of a frame's file: one, or one for each rank (for parallel ParaView)");
  o.piecesByRank = pieces == 1;
  r.text("colour", o.colour, "field that colours the pictures; none: temperature, or speed where there is no heat");
  r.number("colour_min", o.colourMin, "", anyNumber(), "SI value of the lowest colour; none: of all frames");
  r.number("colour_max", o.colourMax, "", anyNumber(), "SI value of the highest colour");
  std::int64_t width = o.width, height = o.height;
  r.whole("width", width, 64, 16384, "of pictures, in pixels");
  r.whole("height", height, 64, 16384, "of pictures, in pixels");
  o.width = static_cast<int>(width);
  o.height = static_cast<int>(height);
  r.table("camera", "where pictures are taken from; without it the view is fitted to all frames", [&](TableReader& c) {
    if (!c.describing()) o.camera.fitted = false;
    c.vector("from", o.camera.from, "m", "place of the camera");
    c.vector("at", o.camera.at, "m", "place that it looks at");
    c.number("field_of_view", o.camera.fieldOfView, "rad", Range{0.01, 3, false, false}, "vertical angle");
  });
}

}  // namespace

void readSections(TableReader& top, SceneReading& x) {
  Scene& s = *x.scene;
  top.text("title", s.title, "one line");
  top.number("spacing", s.spacing, "m", positive(), "distance of particles: the one resolution knob");
  top.number("end", s.end, "s", notNegative(), "simulated time");
  std::int64_t seed = static_cast<std::int64_t>(s.seed);
  top.whole("seed", seed, 0, INT64_MAX, "of everything random");
  s.seed = static_cast<std::uint64_t>(seed);
  top.node("include", "path or list of paths", "scene files that are read first, relative to this one");
  top.table("domain", "the box that is simulated", [&](TableReader& r) { readDomain(r, s.domain); });
  top.table("numerics", "choices of the method", [&](TableReader& r) { readNumerics(r, s.numerics); });
  if (top.describing()) {
    Material standard;
    top.tables("material.NAME", "a material", [&](TableReader& r) { readMaterial(r, standard); });
  } else if (const toml::node* n = top.node("material", "tables", "materials by name")) {
    if (const toml::table* t = n->as_table()) {
      for (const auto& [key, node] : *t) {
        const std::string name(key.str());
        const auto old = std::find_if(s.materials.begin(), s.materials.end(), [&](const Material& m) { return m.name == name; });
        Material& m = old != s.materials.end() ? *old : s.materials.emplace_back();
        m.name = name;
        top.namedTable(node, "material." + name, [&](TableReader& r) { readMaterial(r, m); });
      }
    } else {
      top.fail("material", "expected tables such as [material.wax]");
    }
  }
  top.tables("body", "something made of particles", [&](TableReader& r) { readBody(r, x); });
  top.tables("emitter", "an opening that particles come out of", [&](TableReader& r) { readEmitter(r, x); });
  top.tables("obstacle", "something that particles do not pass", [&](TableReader& r) { readObstacle(r, x); });
  if (!top.describing()) top.tables("wall", "", [&](TableReader& r) { readObstacle(r, x); });
  top.table("output", "frames, checkpoints, pictures", [&](TableReader& r) { readOutput(r, s.output); });
}

void checkScene(SceneReading& x, std::vector<SceneError>& errors) {
  Scene& s = *x.scene;
  std::set<std::string> names;
  for (const Material& m : s.materials) names.insert(m.name);
  const auto resolve = [&](const std::string& name, const SourcePlace& where, const std::string& who, int& index) {
    for (std::size_t k = 0; k < s.materials.size(); k++)
      if (s.materials[k].name == name) return static_cast<void>(index = static_cast<int>(k));
    const std::string near = nearestWord(name, names);
    errors.push_back({where, who + ": " + (name.empty() ? "its material is missing" : "there is no material '" + name + "'") + (near.empty() ? "" : "; did you mean '" + near + "'?")});
  };
  for (std::size_t b = 0; b < s.bodies.size(); b++) resolve(x.bodyMaterials[b].first, x.bodyMaterials[b].second, "body '" + s.bodies[b].name + "'", s.bodies[b].material);
  for (std::size_t e = 0; e < s.emitters.size(); e++) resolve(x.emitterMaterials[e].first, x.emitterMaterials[e].second, "emitter '" + s.emitters[e].name + "'", s.emitters[e].material);

  const auto unique = [&](const auto& list, const char* kind) {
    std::set<std::string> seen;
    for (const auto& item : list)
      if (!seen.insert(item.name).second) errors.push_back({item.where, fmt::format("a second {} is called '{}'", kind, item.name)});
  };
  unique(s.bodies, "body");
  unique(s.emitters, "emitter");
  unique(s.obstacles, "obstacle");
  if (s.bodies.empty() && s.emitters.empty()) errors.push_back({{s.file, 1, 1}, "there is nothing to simulate: no [[body]] and no [[emitter]]"});
  if (s.bodies.size() + s.emitters.size() > 65000) errors.push_back({{s.file, 1, 1}, "more than 65000 bodies and emitters"});
  for (const Material& m : s.materials) {
    if (m.liquidAtStart && m.melts()) errors.push_back({m.where, fmt::format("material.{}.phase: the temperature decides the phase of a material that melts; leave phase out", m.name)});
    if (m.latentHeat > 0 && !m.melts()) errors.push_back({m.where, fmt::format("material.{}.latent_heat: needs melts", m.name)});
    if (s.numerics.heat == HeatModel::Paper && m.melts() && !(m.liquidus > m.solidus))
      errors.push_back({m.where, fmt::format("material.{}.melts: the paper's heat model needs two different temperatures", m.name)});
  }
  for (const Emitter& e : s.emitters)
    if (e.end < e.start) errors.push_back({e.where, "emitter '" + e.name + "': end is before start"});
}

}  // namespace thaw
