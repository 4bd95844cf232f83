// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/restart_values.hpp"

#include <fmt/format.h>

#include "io/run/restart/checksum.hpp"

namespace thaw {

void addNumbers(CheckpointValues& record, const std::string& at, RecordNumbers numbers) {
  for (const auto& [key, value] : numbers) record[at + key] = value;
}

void addVector(CheckpointValues& record, const std::string& key, const Vec3d& value) {
  constexpr const char* axes[3] = {".x", ".y", ".z"};
  for (int a = 0; a < 3; a++) record[key + axes[a]] = value[a];
}

void addShape(CheckpointValues& record, const std::string& at, const Shape& s) {
  addNumbers(record, at,
             {{"kind", static_cast<double>(s.kind)},
              {"radius", s.radius},
              {"radius2", s.radius2},
              {"height", s.height},
              {"thickness", s.thickness},
              {"scale", s.scale},
              {"fit_height", s.fitHeight.value_or(0)}});
  addVector(record, at + "size", s.size);
  addVector(record, at + "rotate", s.rotate);
  addVector(record, at + "move", s.move);
  addVector(record, at + "bottom", s.bottom.value_or(Vec3d{}));
  if (s.kind == ShapeKind::HalfSpace) {
    addVector(record, at + "point", s.point);
    addVector(record, at + "normal", s.normal);
  }
  if (!s.mesh.empty())
    addNumbers(record, at,
               {{"mesh_vertices", s.meshFingerprint.vertices},
                {"mesh_triangles", s.meshFingerprint.triangles},
                {"mesh_checksum", s.meshFingerprint.checksum}});
  for (std::size_t k = 0; k < s.parts.size(); k++)
    addShape(record, fmt::format("{}part{}.", at, k), s.parts[k]);
}

void addInTime(CheckpointValues& record, const std::string& key, const FactorInTime& f) {
  for (std::size_t k = 0; k < f.points.size(); k++) {
    record[fmt::format("{}.{}.time", key, k)] = f.points[k].first;
    record[fmt::format("{}.{}.factor", key, k)] = f.points[k].second;
  }
}

void addMotion(CheckpointValues& record, const std::string& at, const std::vector<Keyframe>& motion) {
  for (std::size_t f = 0; f < motion.size(); f++) {
    const std::string key = fmt::format("{}motion.{}.", at, f);
    record[key + "time"] = motion[f].time;
    addVector(record, key + "move", motion[f].move);
    addVector(record, key + "rotate", motion[f].rotate);
  }
}

void addField(CheckpointValues& record, const std::string& key, const PositionField& field) {
  if (!field) return;
  Checksum sum;
  for (const char c : field.text) sum.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  record[key + "_expression"] = sum.asDouble();
}

void addField(CheckpointValues& record, const std::string& at, const VelocityField& field) {
  constexpr const char* axes[3] = {"x", "y", "z"};
  for (std::size_t a = 0; a < 3; a++) {
    addField(record, at + "velocity." + axes[a], field.component[a]);
    if (field.linear) addVector(record, at + "velocity_gradient." + axes[a], field.gradient.row[a]);
  }
}

double checksumOf(const CheckpointValues& record) {
  Checksum sum;
  for (const auto& [key, value] : record) {
    for (const char c : key) sum.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    sum.add(value);
  }
  return sum.asDouble();
}

}  // namespace thaw
