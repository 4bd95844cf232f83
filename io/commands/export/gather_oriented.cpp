// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/oriented/mesh/manifold.hpp"
#include "io/commands/export/gather_scene.hpp"
#include "io/frames/read_oriented_frame.hpp"
#include "io/frames/rows_by_id.hpp"

namespace thaw {

namespace {

/// Mesh of oriented particles: triangles of the smallest-sphere test, and lines of groups without triangles.
/// used: 1 for particles of a triangle or line.
struct OrientedMesh {
  std::vector<Corners> triangles;
  std::vector<std::array<std::uint32_t, 2>> lines;
  std::vector<std::uint8_t> used;
  explicit OrientedMesh(const OrientedFrame& frame)
      : triangles(triangulate(frame.points())), used(frame.positions.size(), 0) {
    std::set<std::uint32_t> meshed;
    for (const Corners& t : triangles) meshed.insert(frame.groups[t[0]]);
    std::vector<std::uint8_t> withoutTriangles;
    for (const std::uint32_t group : frame.groups) withoutTriangles.push_back(!meshed.contains(group));
    lines = joinLines(frame.points(), withoutTriangles);
    for (const Corners& t : triangles)
      for (const std::uint32_t v : t) used[v] = 1;
    for (const auto& l : lines)
      for (const std::uint32_t v : l) used[v] = 1;
  }
};

/// Returns the mesh of each group. The first group of a body has its name.
std::vector<ComponentMesh> meshesOf(const OrientedFrame& frame, const std::vector<Vec3f>& velocities,
                                    const OrientedMesh& made, const std::vector<std::string>& names) {
  std::map<std::uint32_t, ComponentMesh> byGroup;
  std::map<std::uint32_t, std::uint32_t> bodyOf;
  std::vector<std::uint32_t> vertexOf(frame.positions.size());
  for (std::uint32_t i = 0; i < frame.positions.size(); i++) {
    if (!made.used[i]) continue;
    ComponentMesh& m = byGroup[frame.groups[i]];
    m.component = frame.groups[i];
    bodyOf.emplace(frame.groups[i], frame.bodies[i]);
    vertexOf[i] = static_cast<std::uint32_t>(m.mesh.vertices.size());
    m.mesh.vertices.push_back(frame.positions[i]);
    m.normals.push_back(single(frame.normals[i]));
    const auto& c = frame.colours[i];
    m.colours.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
    if (!frame.ids.empty()) m.ids.push_back(frame.ids[i]);
    if (!velocities.empty()) m.velocities.push_back(velocities[i]);
  }
  for (const Corners& t : made.triangles)
    byGroup[frame.groups[t[0]]].mesh.triangles.push_back({vertexOf[t[0]], vertexOf[t[1]], vertexOf[t[2]]});
  for (const auto& l : made.lines)
    byGroup[frame.groups[l[0]]].lines.push_back({vertexOf[l[0]], vertexOf[l[1]]});
  std::vector<ComponentMesh> meshes;
  std::set<std::uint32_t> named;
  for (auto& [group, mesh] : byGroup) {
    const std::uint32_t body = bodyOf.at(group);
    const std::string name = body < names.size() ? names[body] : fmt::format("oriented_{}", body);
    mesh.name = named.insert(body).second ? name : fmt::format("{}_{}", name, group);
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

/// Returns a note on particles without triangle and line: their number and the first id. Empty without such
/// particles.
std::string aloneText(const OrientedFrame& frame, const std::vector<std::uint8_t>& used) {
  const auto alone = std::count(used.begin(), used.end(), std::uint8_t{0});
  if (alone == 0) return "";
  const std::uint64_t first = frame.ids.empty()
                                  ? 0
                                  : frame.ids[static_cast<std::size_t>(
                                        std::find(used.begin(), used.end(), std::uint8_t{0}) - used.begin())];
  return alone == 1 ? fmt::format(
                          "; 1 particle (id {}) has no triangle or line: it has no neighbour within two "
                          "spacings",
                          first)
                    : fmt::format(
                          "; {} particles (the first: id {}) have no triangle or line: they have no "
                          "neighbour within two spacings",
                          alone, first);
}

}  // namespace

void gatherOriented(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes) {
  FrameData all = readShared(group.oriented, job);
  orderById(all);
  const std::vector<Vec3f> velocities = vectorsOf(all.find("velocity"), all.positions.size());
  const OrientedFrame frame = orientedFrameOf(all, group.oriented.string());
  const OrientedMesh made(frame);
  notes.summary += fmt::format("{}{} particles, {} triangles, {} lines (curves){}",
                               notes.summary.empty() ? "" : ", ", frame.positions.size(),
                               made.triangles.size(), made.lines.size(), aloneText(frame, made.used));
  if (job.format->keepsTables && job.contents == orientedContent) {
    all.triangles = made.triangles;
    scene.table = ExportTable{std::move(all), made.lines};
    return;
  }
  scene.objects.push_back(
      {"oriented", ExportKind::Oriented, meshesOf(frame, velocities, made, scene.orientedNames), {}, false});
}

}  // namespace thaw
