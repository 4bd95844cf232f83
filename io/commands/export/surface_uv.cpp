// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/surface_uv.hpp"

#include <limits>

#include "core/domain/emit.hpp"
#include "core/geometry/builtin/builtin_meshes.hpp"
#include "core/geometry/shapes/placed_mesh.hpp"
#include "core/geometry/trees/point_tree.hpp"
#include "core/surface/data/surfel_ids.hpp"
#include "core/surface/seeding/sample_mesh.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

}  // namespace

SurfaceUv::SurfaceUv(const Scene& scene) {
  const MeshLoader load = meshLoader();
  const PeriodicSides sides = periodicSidesOf(scene.domain);
  Vec3d period{};
  for (int a = 0; a < 3; a++)
    if (sides.is[static_cast<std::size_t>(a)]) period[a] = sides.period[a];
  for (std::size_t b = 0; b < scene.bodies.size(); b++) {
    const Shape& shape = scene.bodies[b].shape;
    if (!isSampled(scene, b) || shape.kind != ShapeKind::Mesh || isBuiltin(shape.mesh)) continue;
    TexturedMesh mesh = readTexturedMesh(shape.mesh);
    if (mesh.uv.empty()) continue;
    const TextureLookup texture(std::move(mesh));
    const Placement placed = makePlacedMesh(shape, load).placement;
    const Mat3d back = transpose(placed.rotation);
    const std::vector<SurfaceSample> samples = sampleBody(scene, b, load, period);
    for (std::size_t k = 0; k < samples.size(); k++)
      uv_[surfelBit | particleId(b, k)] = texture.at(back * (samples[k].position - placed.move) /
                                                     placed.scale);
  }
}

void SurfaceUv::addBirths(const SurfaceFrame& frame) {
  for (const ComponentRows& c : rowsByComponent(frame)) {
    std::vector<Vec3d> places;
    std::vector<std::uint32_t> known, born;
    for (const std::uint32_t i : c.rows) {
      if (uv_.contains(frame.ids[i])) known.push_back(i), places.push_back(frame.positions[i]);
      else born.push_back(i);
    }
    if (known.empty() || born.empty()) continue;
    const PointTree tree(places);
    std::vector<Uv> found;
    for (const std::uint32_t i : born)
      found.push_back(uv_.at(frame.ids[known[tree.nearest(frame.positions[i], 1).front()]]));
    for (std::size_t k = 0; k < born.size(); k++) uv_[frame.ids[born[k]]] = found[k];
  }
}

std::vector<Uv> SurfaceUv::of(const SurfaceFrame& frame) const {
  std::vector<Uv> uv;
  uv.reserve(frame.ids.size());
  for (const std::uint64_t id : frame.ids) {
    const auto known = uv_.find(id);
    uv.push_back(known != uv_.end() ? known->second : Uv{none, none});
  }
  return uv;
}

SurfaceUv followUv(const Scene& scene, const std::vector<std::filesystem::path>& frames) {
  SurfaceUv uv(scene);
  if (uv.empty()) return uv;
  for (const std::filesystem::path& file : frames)
    uv.addBirths(readSurfaceFrame(file.string(), [](const std::string&) { return false; }));
  return uv;
}

}  // namespace thaw
