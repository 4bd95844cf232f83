// SPDX-License-Identifier: Apache-2.0
// Shapes of a scene in SI units, and types that all parts of a scene use.
#pragma once
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Position in a file, for messages.
struct SourcePlace {
  std::string file;
  int line = 0, column = 0;
};

/// Fingerprint of a mesh file. It reveals a different mesh under the same name
/// (io/run/restart/mesh_fingerprints.hpp).
struct MeshFingerprint {
  double vertices = 0, triangles = 0, checksum = 0;
};

enum class ShapeKind {
  Box,
  Sphere,
  Cylinder,
  Torus,
  HalfSpace,
  Glass,
  Mesh,
  Union,
  Difference,
  Intersection,
  Extension
};

/// The name of an extension and the values of its keys (core/terms/extensions.hpp).
struct ExtensionSettings {
  std::string name;
  std::map<std::string, double> values;  // by key, SI
  bool heats = false;                    // its load adds heat, so the heat module is active
};

/// Shape in its own frame, which is then scaled, rotated and moved. The signed distance is negative inside.
struct Shape {
  ShapeKind kind = ShapeKind::Box;
  SourcePlace where;
  Vec3d size{1, 1, 1};   // m, Box: edge lengths, centred on the origin
  double radius = 0.5;   // m, Sphere, Cylinder, Glass (outer radius), Torus (ring radius)
  double radius2 = 0.1;  // m, Torus (tube radius)
  double height = 1;  // m, Cylinder, Glass; along z: Cylinder centred, Glass standing on z = 0, open at the
                      // top
  double thickness = 0.01;          // m, Glass: wall and floor
  Vec3d point{}, normal{0, 0, 1};   // HalfSpace: m, 1; the solid is on the side opposite to the normal
  std::string mesh;                 // Mesh: absolute path
  MeshFingerprint meshFingerprint;  // Mesh: set when a run begins
  ExtensionSettings extension;      // Extension: its name, and the values of its keys
  std::vector<Shape> parts;         // Union: all; Difference: first minus the others; Intersection
  // placement: x = move + R * (scale * x_shape), where R rotates about x, then y, then z
  double scale = 1;
  Vec3d rotate{};                   // rad, about x, y, z
  Vec3d move{};                     // m
  std::optional<double> fitHeight;  // m, z extent to which the rotated shape is scaled (place.height)
  std::optional<Vec3d> bottom;      // m, position to which the centre of the bounding box's lowest face is
                                    // moved (place.bottom)
};

}  // namespace thaw
