// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/mesh_packet.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/trees/point_tree.hpp"
#include "io/view/frames/thin_rows.hpp"

namespace thaw {
namespace {

constexpr double verticesPerSurfel = 5;  // in meshes with cubes as wide as the radius of a surfel
constexpr double mostVertices = 100000;

/// Moves a position by whole periods into the domain.
Vec3d wrapped(Vec3d x, const PeriodicSides& sides) {
  for (int a = 0; a < 3; a++)
    if (sides.is[static_cast<std::size_t>(a)])
      x[a] -= sides.period[a] * std::floor((x[a] - sides.min[a]) / sides.period[a]);
  return x;
}

void append(const ComponentMesh& part, ComponentMesh& all) {
  const auto start = static_cast<std::uint32_t>(all.mesh.vertices.size());
  all.mesh.vertices.insert(all.mesh.vertices.end(), part.mesh.vertices.begin(), part.mesh.vertices.end());
  all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
  for (const auto& t : part.mesh.triangles)
    all.mesh.triangles.push_back({start + t[0], start + t[1], start + t[2]});
}

}  // namespace

SurfaceToMesh readSurfaceToMesh(const FrameRequest& q) {
  H5File::openToRead(q.path, Trailer::MustBe).close();
  SurfaceToMesh surface{readSurfaceFrame(q.path, [](const std::string&) { return false; }), {}, q.most};
  std::vector<std::uint64_t>& ids = surface.surfels.ids;
  if (std::count(ids.begin(), ids.end(), 0) > 1) ids.clear();  // the frame has none
  const std::vector<Vec3d>& positions = surface.surfels.positions;
  const double level = thinningLevel(rowsAt(0, positions, {}).size(), q.most);
  surface.drawn = rowsAt(level, positions, ids);
  return surface;
}

MeshDetail detailForPage(std::size_t surfels, std::uint64_t most) {
  const double wanted = std::clamp(static_cast<double>(most), 50.0, mostVertices);
  const double cell = std::sqrt(verticesPerSurfel * static_cast<double>(surfels) / wanted);
  return {.cell = std::max(1.0, cell), .mostOfSize = 0.25, .improved = false};
}

Packet meshPacket(const SurfaceToMesh& surface, const PeriodicSides& sides) {
  const SurfaceFrame& frame = surface.surfels;
  const MeshDetail detail = detailForPage(frame.positions.size(), surface.most);
  ComponentMesh all;
  for (const ComponentRows& component : rowsByComponent(frame))
    append(detailedMeshOfComponent(frame, component, frame.colours, sides, detail), all);
  std::vector<Vec3d> drawn;
  drawn.reserve(surface.drawn.size());
  for (const std::uint32_t i : surface.drawn) drawn.push_back(frame.positions[i]);
  std::vector<std::uint32_t> nearest;
  nearest.reserve(all.mesh.vertices.size());
  if (!drawn.empty()) {
    const PointTree tree(drawn);
    for (const Vec3d& x : all.mesh.vertices) nearest.push_back(tree.nearest(wrapped(x, sides), 1).front());
  } else {
    all = {};
  }
  Packet packet;
  packet.header = {{"type", "mesh"},
                   {"time", frame.time},
                   {"cell", detail.cell},
                   {"fields", nlohmann::ordered_json::array()}};
  packet.addPositions(all.mesh.vertices);
  packet.addNormals(all.normals);
  packet.addTriangles(all.mesh.triangles);
  packet.add("surfel", std::span<const std::uint32_t>(nearest), 1);
  return packet;
}

}  // namespace thaw
