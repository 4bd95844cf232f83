// SPDX-License-Identifier: Apache-2.0
#include "io/view/run/scene_view.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/shapes/pose.hpp"
#include "core/terms/find_modules.hpp"
#include "io/hdf5/h5_file.hpp"
#include "io/render/scene_job.hpp"
#include "io/render/scene_marks.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/surface_mesh/obstacle_mesh.hpp"

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

Json vectorJson(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Returns red, green and blue, 0 to 255.
Json colourJson(std::uint32_t colour) { return {colour & 255, colour >> 8 & 255, colour >> 16 & 255}; }

Json colourJson(const Rgb& c) { return {c.r, c.g, c.b}; }
Json colourJson(const std::optional<Rgb>& c) { return c ? colourJson(*c) : Json(nullptr); }

/// Returns lights with their directions (unit vectors) and linear colours. Without lights the page has its
/// own behind the camera.
Json lightingJson(const Lighting& lighting) {
  Json lights = Json::array();
  const auto add = [&](const Vec3d& direction, const Vec3f& colour) {
    lights.push_back({{"to_light", vectorJson(normalized(direction))}, {"colour", vectorJson(wide(colour))}});
  };
  if (lighting.sun) add(*lighting.sun, {1, 1, 1});
  for (const DistantLight& l : lighting.lights) add(l.direction, l.colour);
  return {
      {"lights", lights},
      {"ambient", lighting.ambient},
      {"background", colourJson(lighting.background)},
      {"background_top", colourJson(lighting.backgroundTop ? lighting.backgroundTop : lighting.background)}};
}

const char* sideName(Side side) {
  return side == Side::Wall ? "wall" : side == Side::Periodic ? "periodic" : "open";
}

std::string colourField(const Scene& scene) {
  if (!scene.output.colour.empty()) return scene.output.colour;
  if (modulesOf(scene).heat) return "temperature";
  return hasContinuum(scene) ? "speed" : "surface";
}

/// Adds a plane or the triangles of an obstacle. Vertices are numbered over all obstacles.
void addObstacle(const Obstacle& obstacle, Json& entry, std::vector<float>& vertices,
                 std::vector<std::uint32_t>& triangles) {
  const auto distance = makeSignedDistance(obstacle.shape, meshLoader());
  const Bounds box = distance->bounds();
  entry["first"] = triangles.size() / 3;
  entry["triangles"] = 0;
  if (!std::isfinite(length(box.max - box.min))) {
    Vec3d normal;
    const double away = distance->distance({}, &normal);
    entry["plane"] = {{"point", vectorJson(-away * normal)}, {"normal", vectorJson(normal)}};
    return;
  }
  const TriangleMesh mesh = boundedMesh(obstacle.shape, *distance);
  const auto start = static_cast<std::uint32_t>(vertices.size() / 3);
  for (const Vec3d& v : mesh.vertices)
    for (int a = 0; a < 3; a++) vertices.push_back(static_cast<float>(v[a]));
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t corner : t) triangles.push_back(start + corner);
  entry["triangles"] = mesh.triangles.size();
}

}  // namespace

Scene sceneOfFrame(const std::filesystem::path& frame) {
  const H5File file = H5File::openToRead(frame.string(), Trailer::MustBe);
  if (!file.has("/run/scene_toml") || !file.has("/run/scene_name"))
    throw IoError(frame.string(), "has no scene");
  return sceneOfText(file.readText("/run/scene_toml"), file.readText("/run/scene_name"));
}

Json sceneView(const Scene& scene) {
  Json view = {{"title", scene.title},
               {"spacing", scene.spacing},
               {"end", std::isfinite(scene.end) ? Json(scene.end) : Json(nullptr)},
               {"domain",
                {{"min", vectorJson(scene.domain.min)},
                 {"max", vectorJson(scene.domain.max)},
                 {"sides", Json::array()}}},
               {"camera", nullptr},
               {"colour", colourField(scene)},
               {"surface", scene.surface.on}};
  for (const auto& axis : scene.domain.side)
    view["domain"]["sides"].push_back({sideName(axis[0]), sideName(axis[1])});
  const Output& o = scene.output;
  if (!o.camera.fitted)
    view["camera"] = {{"from", vectorJson(o.camera.from)},
                      {"at", vectorJson(o.camera.at)},
                      {"field_of_view_deg", o.camera.fieldOfView * 180 / std::numbers::pi}};
  view["lighting"] = lightingJson(lightingOf(o));
  view["colour_min"] = o.colourMin ? Json(*o.colourMin) : Json(nullptr);
  view["colour_max"] = o.colourMax ? Json(*o.colourMax) : Json(nullptr);
  return view;
}

Packet obstacleMeshes(const Scene& scene) {
  Packet packet;
  packet.header["obstacles"] = Json::array();
  std::vector<float> vertices;
  std::vector<std::uint32_t> triangles;
  for (const Obstacle& obstacle : scene.obstacles) {
    Json entry = {{"name", obstacle.name},
                  {"look", obstacle.look == ObstacleLook::Solid ? "solid" : "glass"},
                  {"colour", colourJson(obstacle.colour)}};
    try {
      addObstacle(obstacle, entry, vertices, triangles);
    } catch (const std::exception& error) {  // a mesh that is missing, for example on another machine
      entry["problem"] = error.what();
    }
    packet.header["obstacles"].push_back(entry);
  }
  packet.add("position", std::span<const float>(vertices), 3);
  packet.add("triangles", std::span<const std::uint32_t>(triangles), 3);
  return packet;
}

Packet markLines(const Scene& scene) {
  Packet packet;
  packet.header["marks"] = Json::array();
  std::vector<float> ends;
  try {
    for (const Mark& mark : sceneMarks(scene)) {
      if (mark.kind == MarkKind::Domain) continue;  // sceneView has it
      packet.header["marks"].push_back({{"kind", markNames[static_cast<std::size_t>(mark.kind)]},
                                        {"name", mark.name},
                                        {"first", ends.size() / 6},
                                        {"lines", mark.lines.size()}});
      for (const auto& line : mark.lines)
        for (const Vec3d& end : line)
          for (int a = 0; a < 3; a++) ends.push_back(static_cast<float>(end[a]));
    }
  } catch (const std::exception&) {  // obstacleMeshes reports a missing mesh
  }
  packet.add("position", std::span<const float>(ends), 3);
  return packet;
}

Json obstaclePoses(const Scene& scene, double time) {
  Json poses = Json::array();
  for (const Obstacle& obstacle : scene.obstacles) {
    const Pose pose = poseAt(obstacle.motion, time);
    Json rotation = Json::array();
    for (int r = 0; r < 3; r++)
      for (int c = 0; c < 3; c++) rotation.push_back(pose.rotation.row[r][c]);
    poses.push_back(
        {{"present", !(time >= obstacle.until)}, {"move", vectorJson(pose.move)}, {"rotation", rotation}});
  }
  return poses;
}

}  // namespace thaw
