#include "io/run/scene_marks.hpp"

#include <fmt/format.h>

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
