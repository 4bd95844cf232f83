// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "io/commands/export/gather_scene.hpp"
#include "io/frames/rows_by_id.hpp"

namespace thaw {

void gatherParticles(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes) {
  FrameData frame = readShared(group.particles, job);
  orderById(frame);
  const std::size_t rows = frame.positions.size();
  ExportPoints points;
  points.name = "particles";
  for (const Vec3d& x : frame.positions) points.positions.push_back(single(x));
  points.velocities = vectorsOf(frame.find("velocity"), rows);
  points.temperatures = numbersOf(frame.find("temperature"), rows);
  points.liquid = numbersOf(frame.find("liquid"), rows);
  points.ids = idsOf(frame);
  points.width = static_cast<float>(scene.spacing > 0 ? scene.spacing : 0.01);
  if (const FrameColumn* volume = frame.find("volume")) {
    points.widths.emplace();
    for (const float v : numbersOf(volume, rows)) points.widths->push_back(std::cbrt(v));
  }
  const FrameColumn* field = frame.find(job.options->field);
  if (field && field->components == 1)
    for (const Rgb& c : coloursOfColumn(*field, rows, *job.options))
      points.colours.push_back({static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)});
  scene.points = std::move(points);
  notes.summary += fmt::format("{}{} particles", notes.summary.empty() ? "" : ", ", rows);
}

}  // namespace thaw
