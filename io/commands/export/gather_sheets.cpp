// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "io/commands/export/gather_scene.hpp"
#include "io/frames/rows_by_id.hpp"
#include "io/hdf5/io_error.hpp"

namespace thaw {

namespace {

/// Fields of the rows of a frame of sheets.
struct SheetRows {
  std::vector<std::uint64_t> ids;
  std::vector<Vec3f> velocities;
  std::vector<float> temperatures;
  const FrameColumn *body, *colour;
  explicit SheetRows(const FrameData& frame, const std::string& path)
      : ids(idsOf(frame)),
        velocities(vectorsOf(frame.find("velocity"), frame.positions.size())),
        temperatures(numbersOf(frame.find("temperature"), frame.positions.size())),
        body(frame.find("sheet_body")),
        colour(frame.find("color")) {
    if (!body || !colour) throw IoError(path, "has no fields 'sheet_body' and 'color'");
  }
  void addVertex(const FrameData& frame, std::size_t i, ComponentMesh& m) const {
    m.mesh.vertices.push_back(frame.positions[i]);
    m.normals.push_back({});
    if (!ids.empty()) m.ids.push_back(ids[i]);
    if (!velocities.empty()) m.velocities.push_back(velocities[i]);
    if (!temperatures.empty()) m.temperatures.push_back(temperatures[i]);
    m.colours.push_back({static_cast<float>(colour->value(i, 0)), static_cast<float>(colour->value(i, 1)),
                         static_cast<float>(colour->value(i, 2))});
  }
};

/// Returns one mesh per sheet. Vertex normals are area-weighted means over the adjacent triangles.
std::map<std::uint32_t, ComponentMesh> meshesByBody(const FrameData& frame, const SheetRows& rows) {
  std::map<std::uint32_t, ComponentMesh> byBody;
  std::vector<std::uint32_t> vertexOf(frame.positions.size());
  for (std::size_t i = 0; i < frame.positions.size(); i++) {
    ComponentMesh& m = byBody[static_cast<std::uint32_t>(rows.body->value(i))];
    vertexOf[i] = static_cast<std::uint32_t>(m.mesh.vertices.size());
    rows.addVertex(frame, i, m);
  }
  for (const auto& t : frame.triangles) {
    ComponentMesh& m = byBody[static_cast<std::uint32_t>(rows.body->value(t[0]))];
    const Vec3d n = cross(frame.positions[t[1]] - frame.positions[t[0]],
                          frame.positions[t[2]] - frame.positions[t[0]]);
    for (const std::uint32_t k : t) m.normals[vertexOf[k]] += single(n);
    m.mesh.triangles.push_back({vertexOf[t[0]], vertexOf[t[1]], vertexOf[t[2]]});
  }
  for (auto& [number, m] : byBody) {
    m.component = number;
    for (Vec3f& n : m.normals) n = dot(n, n) > 0 ? n * (1 / std::sqrt(dot(n, n))) : Vec3f{0, 0, 1};
  }
  return byBody;
}

}  // namespace

void gatherSheets(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes) {
  FrameData frame = readShared(group.sheets, job);
  orderById(frame);  // the same order in all frames, for animations
  if (job.format->keepsTables && job.contents == sheetContent) {
    notes.summary = fmt::format("{} vertices, {} triangles", frame.positions.size(), frame.triangles.size());
    scene.table = ExportTable{std::move(frame), {}};
    return;
  }
  const SheetRows rows(frame, group.sheets.string());
  std::size_t sheets = 0;
  for (auto& [number, mesh] : meshesByBody(frame, rows)) {
    ExportObject sheet{
        number < scene.sheetNames.size() ? scene.sheetNames[number] : fmt::format("sheet_{}", number),
        ExportKind::Sheet,
        {},
        {},
        false};
    mesh.name = sheet.name;
    sheet.parts.push_back(std::move(mesh));
    scene.objects.push_back(std::move(sheet));
    sheets++;
  }
  notes.summary += fmt::format("{}{} vertices, {} {}, {} triangles", notes.summary.empty() ? "" : ", ",
                               frame.positions.size(), sheets, sheets == 1 ? "sheet" : "sheets",
                               frame.triangles.size());
}

}  // namespace thaw
