#include "io/run/scene_marks.hpp"

#include <fmt/format.h>

#include <utility>

namespace thaw {
namespace {

constexpr const char* axes[3] = {"x", "y", "z"};

template<class List> void addNames(CheckpointValues& marks, const char* group, const List& list) {
  for (std::size_t k = 0; k < list.size(); k++) marks[fmt::format("{}.{}", group, list[k].name)] = static_cast<double>(k);
}

/// An emitter numbers its particles by what it has let out since its start, so that its schedule is part of the state.
void addEmitter(CheckpointValues& marks, const Emitter& e) {
  const std::string at = "emitter." + e.name + ".";
  marks[at + "radius"] = e.disc ? e.radius : 0;
  marks[at + "width"] = e.disc ? 0 : e.width;
  marks[at + "depth"] = e.disc ? 0 : e.depth;
  marks[at + "speed"] = e.speed;
  marks[at + "rate"] = e.rate;
  marks[at + "start"] = e.start;
  marks[at + "material"] = e.material;
  for (int a = 0; a < 3; a++) {
    marks[at + "centre." + axes[a]] = e.centre[a];
    marks[at + "direction." + axes[a]] = e.direction[a];
  }
}

/// What a shape is made and placed by, and its parts'.
void addShape(CheckpointValues& marks, const std::string& at, const Shape& s) {
  marks[at + "kind"] = static_cast<double>(s.kind);
  const std::pair<const char*, double> numbers[] = {{"radius", s.radius}, {"radius2", s.radius2}, {"height", s.height}, {"thickness", s.thickness}, {"scale", s.scale}, {"fit_height", s.fitHeight.value_or(0)}};
  for (const auto& [key, value] : numbers) marks[at + key] = value;
  const std::pair<const char*, Vec3d> vectors[] = {{"size", s.size}, {"rotate", s.rotate}, {"move", s.move}, {"bottom", s.bottom.value_or(Vec3d{})}};
  for (const auto& [key, value] : vectors)
    for (int a = 0; a < 3; a++) marks[at + key + "." + axes[a]] = value[a];
  for (std::size_t k = 0; k < s.parts.size(); k++) addShape(marks, fmt::format("{}part{}.", at, k), s.parts[k]);
}

/// A sheet's edges, triangles and places of rest are made anew from its mesh at a restart.
void addSheet(CheckpointValues& marks, const SheetBody& b) {
  const std::string at = "sheet." + b.name + ".";
  const std::pair<const char*, double> numbers[] = {{"mesh", static_cast<double>(b.mesh)}, {"width", b.width}, {"depth", b.depth}, {"height", b.height}, {"radius", b.radius}, {"spacing", b.spacing},
                                                    {"ribs", b.ribs}, {"rib_height", b.ribHeight}, {"wrinkles", b.wrinkles}, {"wrinkle_height", b.wrinkleHeight}};
  for (const auto& [key, value] : numbers) marks[at + key] = value;
  for (int a = 0; a < 3; a++) marks[at + "warp_direction." + axes[a]] = b.warpDirection[a];
  addShape(marks, at + "place.", b.shape);
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
  for (const SheetBody& b : s.sheets) addSheet(marks, b);
  for (const OrientedBody& b : s.oriented) {  // particles name their anchors by place in the list
    marks["oriented." + b.name + ".spacing"] = b.spacing;
    marks["oriented." + b.name + ".anchors"] = static_cast<double>(b.anchors.size());
  }
  return marks;
}

std::vector<std::string> sceneDifferences(const CheckpointValues& stored, const Scene& scene) {
  const CheckpointValues now = sceneMarks(scene);
  std::vector<std::string> differences;
  for (const auto& [key, value] : stored) {
    const auto it = now.find(key);
    if (it == now.end()) differences.push_back(fmt::format("{} is not in the scene any more", key));
    else if (it->second != value) differences.push_back(fmt::format("{} was {}, and is {} now (SI, or place in its list)", key, value, it->second));
  }
  for (const auto& [key, value] : now)
    if (!stored.contains(key)) differences.push_back(fmt::format("{} was not in the scene then", key));
  return differences;
}

}  // namespace thaw
