// SPDX-License-Identifier: Apache-2.0
// Contents of one exported frame.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/shapes/pose.hpp"
#include "core/scene/scene.hpp"
#include "io/frames/frame.hpp"
#include "io/frames/read_surface_frame.hpp"
#include "io/image/render_style.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

enum class ExportKind { Surface, Sheet, Oriented, Obstacle };

/// Meshes with one name: all components of a surface, a sheet, the oriented bodies, or an obstacle.
struct ExportObject {
  std::string name;
  ExportKind kind = ExportKind::Surface;
  std::vector<ComponentMesh> parts;
  std::optional<Pose> pose;  ///< rigid obstacles only: the parts are at rest, and the same in all frames
  bool moves = false;        ///< the pose changes during the run
  float opacity = 1;
};

/// Particles. Each vector has one element per particle, or is empty.
struct ExportPoints {
  std::string name;
  std::vector<Vec3f> positions;             ///< m
  std::vector<Vec3f> velocities;            ///< m/s
  std::vector<Vec3f> colours;               ///< sRGB 0 to 255
  std::vector<float> temperatures, liquid;  ///< K; 1
  std::vector<std::uint64_t> ids;
  float width = 0;                           ///< m, diameter of all
  std::optional<std::vector<float>> widths;  ///< m, one per particle, if they differ
};

/// Sheets or oriented particles with all fields of their frame, for formats that keep them.
struct ExportTable {
  FrameData frame;  ///< with triangles
  std::vector<std::array<std::uint32_t, 2>> lines;
};

/// Lengths are in metres, z is up.
struct ExportScene {
  double time = 0;      ///< s
  std::string name;     ///< scene name
  double interval = 0;  ///< s between frames; 0: unknown
  std::vector<ExportObject> objects;
  std::optional<ExportPoints> points;
  std::optional<SurfaceFrame> surfels;
  std::vector<Rgb> surfelColours;  ///< one per surfel
  std::optional<ExportTable> table;
  RenderStyle style;   ///< camera, size of the picture, floors
  double spacing = 0;  ///< m, between particles; 0: unknown
  PeriodicSides periodic;
  std::vector<std::string> sheetNames, orientedNames;  ///< one per body of the scene
  std::vector<std::string> sourceNames;                ///< one per source of particles: bodies, then emitters
};

/// Returns an object's meshes in the scene: vertices, normals and velocities of an obstacle follow its pose.
std::vector<ComponentMesh> placedParts(const ExportObject& object);

/// Returns all meshes of a scene in order.
std::vector<ComponentMesh> placedParts(const ExportScene& scene);

}  // namespace thaw
