#include "io/run/mark_values.hpp"

#include <fmt/format.h>

#include "io/run/checksum.hpp"

namespace thaw {

void addNumbers(CheckpointValues& marks, const std::string& at, MarkNumbers numbers) {
  for (const auto& [key, value] : numbers) marks[at + key] = value;
}

void addVector(CheckpointValues& marks, const std::string& key, const Vec3d& value) {
  constexpr const char* axes[3] = {".x", ".y", ".z"};
  for (int a = 0; a < 3; a++) marks[key + axes[a]] = value[a];
}

void addShape(CheckpointValues& marks, const std::string& at, const Shape& s) {
  addNumbers(marks, at,
             {{"kind", static_cast<double>(s.kind)},
              {"radius", s.radius},
              {"radius2", s.radius2},
              {"height", s.height},
              {"thickness", s.thickness},
              {"scale", s.scale},
              {"fit_height", s.fitHeight.value_or(0)}});
  addVector(marks, at + "size", s.size);
  addVector(marks, at + "rotate", s.rotate);
  addVector(marks, at + "move", s.move);
  addVector(marks, at + "bottom", s.bottom.value_or(Vec3d{}));
  if (s.kind == ShapeKind::HalfSpace) {
    addVector(marks, at + "point", s.point);
    addVector(marks, at + "normal", s.normal);
  }
  if (!s.mesh.empty())
    addNumbers(marks, at,
               {{"mesh_vertices", s.meshMark.vertices},
                {"mesh_triangles", s.meshMark.triangles},
                {"mesh_checksum", s.meshMark.checksum}});
  for (std::size_t k = 0; k < s.parts.size(); k++)
    addShape(marks, fmt::format("{}part{}.", at, k), s.parts[k]);
}

void addInTime(CheckpointValues& marks, const std::string& key, const FactorInTime& f) {
  for (std::size_t k = 0; k < f.points.size(); k++) {
    marks[fmt::format("{}.{}.time", key, k)] = f.points[k].first;
    marks[fmt::format("{}.{}.factor", key, k)] = f.points[k].second;
  }
}

void addMotion(CheckpointValues& marks, const std::string& at, const std::vector<Keyframe>& motion) {
  for (std::size_t f = 0; f < motion.size(); f++) {
    const std::string key = fmt::format("{}motion.{}.", at, f);
    marks[key + "time"] = motion[f].time;
    addVector(marks, key + "move", motion[f].move);
    addVector(marks, key + "rotate", motion[f].rotate);
  }
}

void addField(CheckpointValues& marks, const std::string& key, const PositionField& field) {
  if (!field) return;
  Checksum sum;
  for (const char c : field.text) sum.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  marks[key + "_expression"] = sum.held();
}

void addField(CheckpointValues& marks, const std::string& at, const VelocityField& field) {
  constexpr const char* axes[3] = {"x", "y", "z"};
  for (std::size_t a = 0; a < 3; a++) {
    addField(marks, at + "velocity." + axes[a], field.component[a]);
    if (field.linear) addVector(marks, at + "velocity_gradient." + axes[a], field.gradient.row[a]);
  }
}

double checksumOf(const CheckpointValues& marks) {
  Checksum sum;
  for (const auto& [key, value] : marks) {
    for (const char c : key) sum.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    sum.add(value);
  }
  return sum.held();
}

}  // namespace thaw
