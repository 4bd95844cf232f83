// SPDX-License-Identifier: Apache-2.0
// Lamps, lasers and heated regions of a scene (core/heat/sources/).
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/scene/motion.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

enum class LampKind { Point, Direction, Area };

/// Source of light. Bodies absorb it with their absorptivity where they are not in shadow.
struct Lamp {
  std::string name;
  SourcePlace where;
  LampKind kind = LampKind::Point;
  double power = 0;                 // W; Point, Area
  double irradiance = 0;            // W/m^2 on a plane normal to the direction; Direction
  Vec3d position{};                 // m; Point, Area: the centre
  Vec3d direction{0, 0, -1};        // 1, direction of the light; any length
  double width = 0.1, depth = 0.1;  // m; Area
  std::vector<Keyframe> motion;
  double start = 0, end = never;  // s
};

/// Beam with a Gaussian profile.
struct Laser {
  std::string name;
  SourcePlace where;
  double power = 0;            // W
  double radius = 1e-3;        // m, at 1/e^2 of the largest intensity
  Vec3d position{};            // m, point on its axis
  Vec3d direction{0, 0, -1};   // 1
  double absorptionDepth = 0;  // m; 0: at the surface
  std::vector<Keyframe> motion;
  double start = 0, end = never;  // s
};

/// Power that the particles within a shape receive, in proportion to their mass.
struct HeatedRegion {
  std::string name;
  SourcePlace where;
  Shape shape;
  double power = 0;   // W
  int material = -1;  // index into Scene::materials; -1: all
  std::vector<Keyframe> motion;
  double start = 0, end = never;  // s
};

}  // namespace thaw
