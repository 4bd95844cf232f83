// Obstacles and the domain's walls as the step sees them: signed distances, moving, of a temperature or insulating.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Wall {
  std::shared_ptr<const SignedDistance> shape;  ///< at rest pose
  Obstacle properties;                          ///< of the scene; domain sides have a name like "domain z low"
  Vec3d move{}, rotate{};                       ///< current pose relative to the rest pose, m, rad
  Vec3d velocity{}, angularVelocity{};          ///< of the pose, m/s, rad/s about the moved origin
  bool present = true;                          ///< false after properties.until
};

struct Walls {
  std::vector<Wall> list;
};

}  // namespace thaw
