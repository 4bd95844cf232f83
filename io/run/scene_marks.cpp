#include "io/run/scene_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/run/mark_words.hpp"

namespace thaw {
namespace {

constexpr const char* axes[3] = {"x", "y", "z"};

template<class List> void addNames(CheckpointValues& marks, const char* group, const List& list) {
  for (std::size_t k = 0; k < list.size(); k++) marks[fmt::format("{}.{}", group, list[k].name)] = static_cast<double>(k);
}

using Numbers = std::initializer_list<std::pair<const char*, double>>;
void addNumbers(CheckpointValues& marks, const std::string& at, Numbers numbers) {
  for (const auto& [key, value] : numbers) marks[at + key] = value;
}
void addVector(CheckpointValues& marks, const std::string& key, const Vec3d& value) {
  for (int a = 0; a < 3; a++) marks[key + "." + axes[a]] = value[a];
}

/// An emitter numbers its particles by what it has let out since its start, so that its schedule is part of the state.
void addEmitter(CheckpointValues& marks, const Emitter& e) {
  const std::string at = "emitter." + e.name + ".";
  addNumbers(marks, at, {{"radius", e.disc ? e.radius : 0}, {"width", e.disc ? 0 : e.width}, {"depth", e.disc ? 0 : e.depth}, {"speed", e.speed}, {"rate", e.rate}, {"start", e.start},
                         {"material", static_cast<double>(e.material)}});
  addVector(marks, at + "centre", e.centre);
  addVector(marks, at + "direction", e.direction);
}

/// What a shape is made and placed by, and its parts'.
void addShape(CheckpointValues& marks, const std::string& at, const Shape& s) {
  addNumbers(marks, at, {{"kind", static_cast<double>(s.kind)}, {"radius", s.radius}, {"radius2", s.radius2}, {"height", s.height}, {"thickness", s.thickness}, {"scale", s.scale},
                         {"fit_height", s.fitHeight.value_or(0)}});
  addVector(marks, at + "size", s.size);
  addVector(marks, at + "rotate", s.rotate);
  addVector(marks, at + "move", s.move);
  addVector(marks, at + "bottom", s.bottom.value_or(Vec3d{}));
  for (std::size_t k = 0; k < s.parts.size(); k++) addShape(marks, fmt::format("{}part{}.", at, k), s.parts[k]);
}

/// What is held has been marked at the start, and a scene without clamps has no column for it.
void addClamps(CheckpointValues& marks, const std::string& at, const std::vector<Shape>& clamps) {
  marks[at + "clamps"] = static_cast<double>(clamps.size());
  for (std::size_t k = 0; k < clamps.size(); k++) addShape(marks, fmt::format("{}clamp.{}.", at, k), clamps[k]);
}

/// A sheet's edges, triangles and places of rest are made anew from its mesh at a restart.
void addSheet(CheckpointValues& marks, const SheetBody& b) {
  const std::string at = "sheet." + b.name + ".";
  // vertices keep their mass and the number of their law
  addNumbers(marks, at, {{"mesh", static_cast<double>(b.mesh)}, {"width", b.width}, {"depth", b.depth}, {"height", b.height}, {"radius", b.radius}, {"spacing", b.spacing}, {"ribs", b.ribs},
                         {"rib_height", b.ribHeight}, {"wrinkles", b.wrinkles}, {"wrinkle_height", b.wrinkleHeight}, {"mass", b.mass}, {"regions", static_cast<double>(b.regions.size())}});
  addVector(marks, at + "warp_direction", b.warpDirection);
  addShape(marks, at + "place.", b.shape);
  addClamps(marks, at, b.clamp);
  for (std::size_t k = 0; k < b.regions.size(); k++) {
    marks[fmt::format("{}region.{}.mass", at, k)] = b.regions[k].factor[placeOf(SheetFactor::Mass)];
    addShape(marks, fmt::format("{}region.{}.", at, k), b.regions[k].shape);
  }
}

// beginnings of the marks that may change
constexpr const char* coefficient = "coefficient.";
constexpr const char* setting = "setting.";
constexpr const char* ofStart = "start.";
bool hasPrefix(const std::string& key, const std::string& prefix) { return key.rfind(prefix, 0) == 0; }
bool mayChange(const std::string& key) { return hasPrefix(key, coefficient) || hasPrefix(key, setting) || hasPrefix(key, ofStart); }

/// Particles are at places that follow from these; anchors and given points are found by them again.
void addOriented(CheckpointValues& marks, const OrientedBody& b) {
  const std::string at = "oriented." + b.name + ".";
  // particles keep their mass and inertia, and name their anchors by place in the list
  addNumbers(marks, at, {{"source", static_cast<double>(b.source)}, {"width", b.width}, {"depth", b.depth}, {"radius", b.radius}, {"bulge", b.bulge}, {"thin", b.thin}, {"spacing", b.spacing},
                         {"density", b.density}, {"inertia", b.inertia}, {"anchors", static_cast<double>(b.anchors.size())}});
  addVector(marks, at + "from", b.from);
  addVector(marks, at + "to", b.to);
  addShape(marks, at + "place.", b.shape);
  for (const auto& [key, list] : {std::pair{"points", &b.points}, std::pair{"normals", &b.normals}}) {
    Vec3d sum{};  // any change of one of them changes this, but by accident
    for (std::size_t k = 0; k < list->size(); k++) sum += (1 + 0.5 * static_cast<double>(k)) * (*list)[k];
    marks[at + key] = static_cast<double>(list->size());
    addVector(marks, at + key + ".sum", sum);
  }
  for (std::size_t k = 0; k < b.anchors.size(); k++) {
    const std::string anchor = fmt::format("{}anchor.{}.", at, k);
    addNumbers(marks, anchor, {{"position", b.anchors[k].position}, {"normal", b.anchors[k].normal}});
    addShape(marks, anchor, b.anchors[k].region);
  }
}

constexpr std::size_t mostTold = 100;  // bodies: of more these marks would be longer than what they are good for

void addStart(CheckpointValues& marks, const Scene& s) {
  for (std::size_t k = 0; k < std::min(mostTold, s.bodies.size()); k++) {
    const Body& b = s.bodies[k];
    const std::string at = ofStart + ("body." + b.name + ".");
    addNumbers(marks, at, {{"temperature", b.temperature}, {"material", b.material}, {"packing", static_cast<double>(b.packing)}});
    addVector(marks, at + "velocity", b.velocity);
    addVector(marks, at + "spin", b.spin);
    addVector(marks, at + "temperature_gradient", b.temperatureGradient);
    addShape(marks, at + "shape.", b.shape);
  }
  for (const OrientedBody& b : s.oriented) {
    const std::string at = ofStart + ("oriented." + b.name + ".");
    addNumbers(marks, at, {{"jitter", b.jitter}, {"relax", static_cast<double>(b.relax)}});
    addVector(marks, at + "velocity", b.velocity);
  }
  for (const SheetBody& b : s.sheets) {
    const std::string at = ofStart + ("sheet." + b.name + ".");
    marks[at + "temperature"] = b.temperature;
    addVector(marks, at + "velocity", b.velocity);
  }
}

void addBlend(CheckpointValues& marks, const std::string& key, const Blend& b) {
  marks[key + ".solid"] = b.solid;
  marks[key + ".liquid"] = b.liquid;
}

void addCoefficients(CheckpointValues& marks, const Material& m) {
  const std::string at = coefficient + ("material." + m.name + ".");
  addNumbers(marks, at, {{"density", m.density}, {"surface_tension", m.surfaceTension}, {"sound_speed", m.soundSpeed}, {"law", static_cast<double>(m.law)}, {"volume_stiffness", m.volumeStiffness},
                         {"hourglass", m.hourglass}, {"break_stretch", m.breakStretch}, {"damping", m.damping}, {"friction", m.friction}, {"restitution", m.restitution},
                         {"latent_heat", m.latentHeat}, {"solidus", m.solidus}, {"liquidus", m.liquidus}});
  for (const auto& [key, blend] : std::initializer_list<std::pair<const char*, const Blend*>>{
           {"viscosity", &m.viscosity}, {"young", &m.young}, {"poisson", &m.poisson}, {"yield_strain", &m.yieldStrain}, {"creep_rate", &m.creepRate}, {"conductivity", &m.conductivity}, {"heat_capacity", &m.heatCapacity}})
    addBlend(marks, at + key, *blend);
}

void addSettings(CheckpointValues& marks, const SurfaceSettings& s) {
  addNumbers(marks, std::string(setting) + "surface.", {{"spacing", s.spacing}, {"support", s.support}, {"particle_support", s.particleSupport}, {"every_steps", static_cast<double>(s.everySteps)},
             {"every_move", s.everyMove}, {"implicit", s.implicit}, {"attract", s.attract}, {"smooth", s.smooth}, {"repel", s.repel}, {"smoothing", static_cast<double>(s.smoothing)},
             {"iso_level", s.isoLevel}, {"least_level", s.leastLevel}, {"damping", s.damping}, {"iterations", static_cast<double>(s.iterations)}, {"stop", s.stop}, {"adapt", s.adapt},
             {"keep_volume", s.keepVolume}, {"merge", static_cast<double>(s.merge)}, {"link_length", s.linkLength}});
  marks[std::string(ofStart) + "surface.source"] = static_cast<double>(s.source);
}

void addInTime(CheckpointValues& marks, const std::string& key, const FactorInTime& f) {
  for (std::size_t k = 0; k < f.points.size(); k++) {
    marks[fmt::format("{}.{}.time", key, k)] = f.points[k].first;
    marks[fmt::format("{}.{}.factor", key, k)] = f.points[k].second;
  }
}

void addCoefficients(CheckpointValues& marks, const SheetBody& b) {
  const std::string at = coefficient + ("sheet." + b.name + ".");
  addNumbers(marks, at, {{"plasticity", b.plasticity}, {"elastic_limit", b.elasticLimit}, {"rest_length", b.restLength}, {"stretch_limit", b.stretchLimit}, {"rigid", b.rigid},
                         {"pull_reach", b.pullReach},
                         {"thickness", b.thickness}, {"contact_rate", b.contactRate}, {"friction", b.friction}, {"restitution", b.restitution},
                         {"self_contact", b.selfContact}, {"heat_capacity", b.heatCapacity}, {"conductance", b.conductance}});
  addVector(marks, at + "wind", b.wind);
  for (std::size_t f = 0; f < sheetFactors; f++) {
    if (static_cast<SheetFactor>(f) == SheetFactor::Mass) continue;  // vertices keep theirs
    const auto& [key, value] = sheetCoefficients[f];
    marks[at + key] = b.*value;
    addInTime(marks, fmt::format("{}{}_in_time", at, key), b.inTime[f]);
    for (std::size_t k = 0; k < b.regions.size(); k++) marks[fmt::format("{}region.{}.{}", at, k, key)] = b.regions[k].factor[f];
  }
  for (std::size_t k = 0; k < b.brushes.size(); k++) {
    const std::string brush = fmt::format("{}brush.{}.", at, k);
    marks[brush + "radius"] = b.brushes[k].radius;
    addVector(marks, brush + "centre", b.brushes[k].centre);
    addVector(marks, brush + "pressure", b.brushes[k].pressure);
    addInTime(marks, brush + "in_time", b.brushes[k].inTime);
  }
}

/// Those to come; of those that have been, changes are told as well, and have no effect any more.
void addEvent(CheckpointValues& marks, const std::string& at, const OrientedEvent& e) {
  addNumbers(marks, at, {{"kind", static_cast<double>(e.kind)}, {"time", e.time}, {"tool", static_cast<double>(e.tool)}, {"radius", e.radius}, {"other", static_cast<double>(e.otherIndex)}});
  const bool cut = e.kind == OrientedEventKind::Cut;
  if (cut && e.tool == CutTool::Plane) addVector(marks, at + "point", e.point), addVector(marks, at + "normal", e.normal);
  if (cut && e.tool == CutTool::Stroke) addVector(marks, at + "direction", e.direction);
  for (std::size_t k = 0; k < e.path.size(); k++) addVector(marks, fmt::format("{}path.{}", at, k), e.path[k]);
  if (e.tool == CutTool::Box) addShape(marks, at + "region.", e.region);
}

void addCoefficients(CheckpointValues& marks, const OrientedBody& b) {
  const std::string at = coefficient + ("oriented." + b.name + ".");
  addNumbers(marks, at, {{"stiffness", b.stiffness}, {"attract", b.attract}, {"coplanar", b.plane}, {"conormal", b.normal}, {"cocircular", b.circle},
                         {"repel_power", static_cast<double>(b.repelPower)}, {"attract_power", static_cast<double>(b.attractPower)}, {"core", b.core}, {"across", b.across},
                         {"along", b.along}, {"support", b.support}, {"facing", b.facing}, {"planar", b.planar}, {"damping", b.damping}, {"spin_damping", b.spinDamping},
                         {"pressure", b.pressure}, {"contact", b.contact}, {"thickness", b.thickness}, {"friction", b.friction}, {"integrator", static_cast<double>(b.integrator)}});
  addNumbers(marks, setting + ("oriented." + b.name + "."),
             {{"growth", static_cast<double>(b.growth)}, {"gap", b.gap}, {"crowd", b.crowd}, {"every", static_cast<double>(b.every)}, {"most", static_cast<double>(b.most)}});
  const std::string events = setting + ("oriented." + b.name + ".");
  for (std::size_t k = 0; k < b.events.size(); k++) addEvent(marks, fmt::format("{}event.{}.", events, k), b.events[k]);
  addVector(marks, at + "push", b.push);
  for (std::size_t k = 0; k < b.fields.size(); k++) {
    const OrientedField& f = b.fields[k];
    const std::string field = fmt::format("{}field.{}.", at, k);
    addNumbers(marks, field, {{"pull", f.pull}, {"radius", f.radius}, {"pressure", f.pressure}, {"from", f.from}, {"until", f.until}, {"everywhere", f.everywhere}});
    addVector(marks, field + "push", f.push);
    addVector(marks, field + "point", f.point);
    addInTime(marks, field + "in_time", f.inTime);
    if (!f.everywhere) addShape(marks, field, f.region);
  }
  for (std::size_t k = 0; k < b.anchors.size(); k++) {
    const std::string anchor = fmt::format("{}anchor.{}.", at, k);
    marks[anchor + "until"] = b.anchors[k].until;
    for (std::size_t f = 0; f < b.anchors[k].motion.size(); f++) {
      const Keyframe& frame = b.anchors[k].motion[f];
      const std::string key = fmt::format("{}motion.{}.", anchor, f);
      marks[key + "time"] = frame.time;
      addVector(marks, key + "move", frame.move);
      addVector(marks, key + "rotate", frame.rotate);
    }
  }
}

/// The same word for another number is a material or body that has another place in its list, which is told by itself.
void tellChange(std::vector<std::string>& changes, const std::string& key, const std::string& was, const std::string& is, const std::string& unit) {
  if (was != is) changes.push_back(fmt::format("{} was {}, and is {} now{}", key, was, is, unit));
}

/// Marks of one prefix that differ, without it.
std::vector<std::string> changesOf(const std::string& prefix, const CheckpointValues& stored, const Scene& scene) {
  const CheckpointValues now = sceneMarks(scene);
  const MarkWords then(stored), words(now);
  std::vector<std::string> changes;
  for (const auto& [key, value] : stored) {
    if (!hasPrefix(key, prefix)) continue;
    const auto it = now.find(key);
    const std::string name = key.substr(prefix.size());
    if (it == now.end()) changes.push_back(fmt::format("{} was {}, and is not in the scene any more", name, then.text(name, value)));
    else if (it->second != value) tellChange(changes, name, then.text(name, value), words.text(name, it->second), then.unit(name));
  }
  for (const auto& [key, value] : now)
    if (hasPrefix(key, prefix) && !stored.contains(key)) changes.push_back(fmt::format("{} was not in the scene then, and is {} now", key.substr(prefix.size()), words.text(key.substr(prefix.size()), value)));
  return changes;
}

}  // namespace

CheckpointValues sceneMarks(const Scene& s) {
  CheckpointValues marks;
  marks["spacing"] = s.spacing;
  marks["seed"] = static_cast<double>(s.seed);
  marks["numerics.support"] = s.numerics.support;
  marks["numerics.bond_support"] = s.numerics.bondSupport;       // bonds that are there were made with it
  marks["numerics.heat"] = static_cast<double>(s.numerics.heat);  // enthalpy is not kept by the plain temperature model
  marks["output.every"] = s.output.every;                        // the numbers of frames would run into those that are there
  for (int a = 0; a < 3; a++) {
    const std::string axis = axes[a];
    marks["domain.min." + axis] = s.domain.min[a];
    marks["domain.max." + axis] = s.domain.max[a];
    marks["domain.gravity." + axis] = s.domain.gravity[a];  // the ledger reckons potential and impulse from the start
    marks["domain.periodic." + axis] = s.domain.side[static_cast<std::size_t>(a)][0] == Side::Periodic;
  }
  if (s.surface.on) marks["surface"] = 1;  // begins with the bodies
  addNames(marks, "material", s.materials);
  addNames(marks, "body", s.bodies);
  addNames(marks, "emitter", s.emitters);
  addNames(marks, "oriented", s.oriented);
  addNames(marks, "sheet", s.sheets);
  for (const Emitter& e : s.emitters) addEmitter(marks, e);
  for (const SheetBody& b : s.sheets) {
    addSheet(marks, b);
    addCoefficients(marks, b);
  }
  for (const OrientedBody& b : s.oriented) {
    addOriented(marks, b);
    addCoefficients(marks, b);
  }
  for (const Material& m : s.materials) addCoefficients(marks, m);
  if (s.surface.on) addSettings(marks, s.surface);
  for (std::size_t k = 0; k < std::min(mostTold, s.bodies.size()); k++)
    if (!s.bodies[k].clamp.empty()) addClamps(marks, "body." + s.bodies[k].name + ".", s.bodies[k].clamp);
  addStart(marks, s);
  return marks;
}

std::vector<std::string> sceneDifferences(const CheckpointValues& stored, const Scene& scene) {
  const CheckpointValues now = sceneMarks(scene);
  const MarkWords then(stored), words(now);
  std::vector<std::string> differences;
  for (const auto& [key, value] : stored) {
    if (mayChange(key)) continue;
    const auto it = now.find(key);
    if (it == now.end()) differences.push_back(fmt::format("{} is not in the scene any more", key));
    else if (it->second != value) tellChange(differences, key, then.text(key, value), words.text(key, it->second), then.unit(key));
  }
  for (const auto& [key, value] : now)
    if (!mayChange(key) && !stored.contains(key)) differences.push_back(fmt::format("{} was not in the scene then", key));
  return differences;
}

std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene) { return changesOf(coefficient, stored, scene); }

std::vector<std::string> settingChanges(const CheckpointValues& stored, const Scene& scene) { return changesOf(setting, stored, scene); }

std::vector<std::string> changesOfTheStart(const CheckpointValues& stored, const Scene& scene) { return changesOf(ofStart, stored, scene); }

}  // namespace thaw
