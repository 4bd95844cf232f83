#include "io/run/scene_marks.hpp"

#include <fmt/format.h>

#include <utility>

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

/// A sheet's edges, triangles and places of rest are made anew from its mesh at a restart.
void addSheet(CheckpointValues& marks, const SheetBody& b) {
  const std::string at = "sheet." + b.name + ".";
  // vertices keep their mass and the number of their law
  addNumbers(marks, at, {{"mesh", static_cast<double>(b.mesh)}, {"width", b.width}, {"depth", b.depth}, {"height", b.height}, {"radius", b.radius}, {"spacing", b.spacing}, {"ribs", b.ribs},
                         {"rib_height", b.ribHeight}, {"wrinkles", b.wrinkles}, {"wrinkle_height", b.wrinkleHeight}, {"mass", b.mass}, {"regions", static_cast<double>(b.regions.size())}});
  addVector(marks, at + "warp_direction", b.warpDirection);
  addShape(marks, at + "place.", b.shape);
  for (std::size_t k = 0; k < b.regions.size(); k++) {
    marks[fmt::format("{}region.{}.mass", at, k)] = b.regions[k].mass;
    addShape(marks, fmt::format("{}region.{}.", at, k), b.regions[k].shape);
  }
}

constexpr const char* coefficient = "coefficient.";  // begins the marks that may change
bool mayChange(const std::string& key) { return key.rfind(coefficient, 0) == 0; }

void addInTime(CheckpointValues& marks, const std::string& key, const FactorInTime& f) {
  for (std::size_t k = 0; k < f.points.size(); k++) {
    marks[fmt::format("{}.{}.time", key, k)] = f.points[k].first;
    marks[fmt::format("{}.{}.factor", key, k)] = f.points[k].second;
  }
}

void addCoefficients(CheckpointValues& marks, const SheetBody& b) {
  const std::string at = coefficient + ("sheet." + b.name + ".");
  addNumbers(marks, at, {{"damping", b.damping}, {"stiffness", b.stiffness}, {"plasticity", b.plasticity}, {"elastic_limit", b.elasticLimit}, {"warp", b.warp}, {"weft", b.weft},
                         {"shear", b.shear}, {"rest_length", b.restLength}, {"bending", b.bending}, {"stretch_limit", b.stretchLimit}, {"rigid", b.rigid},
                         {"volume_stiffness", b.volumeStiffness}, {"push", b.push}, {"pull", b.pull}, {"pull_reach", b.pullReach}, {"wind_density", b.windDensity}, {"wrap", b.wrap},
                         {"thickness", b.thickness}, {"contact_rate", b.contactRate}, {"friction", b.friction}, {"restitution", b.restitution},
                         {"self_contact", b.selfContact}, {"heat_capacity", b.heatCapacity}, {"conductance", b.conductance}});
  addVector(marks, at + "wind", b.wind);
  addInTime(marks, at + "stiffness_in_time", b.stiffnessInTime);
  addInTime(marks, at + "damping_in_time", b.dampingInTime);
  addInTime(marks, at + "wrap_in_time", b.wrapInTime);
  for (std::size_t k = 0; k < b.regions.size(); k++) addNumbers(marks, fmt::format("{}region.{}.", at, k), {{"damping", b.regions[k].damping}, {"stiffness", b.regions[k].stiffness}});
  for (std::size_t k = 0; k < b.brushes.size(); k++) {
    const std::string brush = fmt::format("{}brush.{}.", at, k);
    marks[brush + "radius"] = b.brushes[k].radius;
    addVector(marks, brush + "centre", b.brushes[k].centre);
    addVector(marks, brush + "pressure", b.brushes[k].pressure);
    addInTime(marks, brush + "in_time", b.brushes[k].inTime);
  }
}

void addCoefficients(CheckpointValues& marks, const OrientedBody& b) {
  const std::string at = coefficient + ("oriented." + b.name + ".");
  addNumbers(marks, at, {{"density", b.density}, {"inertia", b.inertia}, {"stiffness", b.stiffness}, {"attract", b.attract}, {"coplanar", b.plane}, {"conormal", b.normal}, {"cocircular", b.circle},
                         {"repel_power", static_cast<double>(b.repelPower)}, {"attract_power", static_cast<double>(b.attractPower)}, {"core", b.core}, {"across", b.across},
                         {"along", b.along}, {"support", b.support}, {"facing", b.facing}, {"planar", b.planar}, {"damping", b.damping}, {"spin_damping", b.spinDamping},
                         {"pressure", b.pressure}, {"contact", b.contact}, {"thickness", b.thickness}, {"friction", b.friction}, {"integrator", static_cast<double>(b.integrator)},
                         {"growth", static_cast<double>(b.growth)}, {"gap", b.gap}, {"crowd", b.crowd}, {"every", static_cast<double>(b.every)}, {"most", static_cast<double>(b.most)}});
  addVector(marks, at + "push", b.push);
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
  for (const OrientedBody& b : s.oriented) {  // particles name their anchors by place in the list
    addCoefficients(marks, b);
    marks["oriented." + b.name + ".spacing"] = b.spacing;
    marks["oriented." + b.name + ".anchors"] = static_cast<double>(b.anchors.size());
  }
  return marks;
}

std::vector<std::string> sceneDifferences(const CheckpointValues& stored, const Scene& scene) {
  const CheckpointValues now = sceneMarks(scene);
  std::vector<std::string> differences;
  for (const auto& [key, value] : stored) {
    if (mayChange(key)) continue;
    const auto it = now.find(key);
    if (it == now.end()) differences.push_back(fmt::format("{} is not in the scene any more", key));
    else if (it->second != value) differences.push_back(fmt::format("{} was {}, and is {} now (SI, or place in its list)", key, value, it->second));
  }
  for (const auto& [key, value] : now)
    if (!mayChange(key) && !stored.contains(key)) differences.push_back(fmt::format("{} was not in the scene then", key));
  return differences;
}

std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene) {
  const CheckpointValues now = sceneMarks(scene);
  std::vector<std::string> changes;
  const std::size_t skip = std::string(coefficient).size();
  for (const auto& [key, value] : stored) {
    if (!mayChange(key)) continue;
    const auto it = now.find(key);
    if (it == now.end()) changes.push_back(fmt::format("{} was {}, and is not in the scene any more", key.substr(skip), value));
    else if (it->second != value) changes.push_back(fmt::format("{} was {}, and is {} now (SI, or place in its list)", key.substr(skip), value, it->second));
  }
  for (const auto& [key, value] : now)
    if (mayChange(key) && !stored.contains(key)) changes.push_back(fmt::format("{} was not in the scene then, and is {} now", key.substr(skip), value));
  return changes;
}

}  // namespace thaw
