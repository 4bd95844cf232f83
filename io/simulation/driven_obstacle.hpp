// SPDX-License-Identifier: Apache-2.0
// An obstacle that a program moves, and the load of the particles on it. This is coupling with a body
// outside of thaw, in both directions.
//
//   thaw::DrivenObstacle ball(sim, "ball");
//   sim.onStep([&] {
//     const thaw::ObstacleLoad load = ball.load();   // N
//     ball.move({.position = x, .velocity = v});     // m, m/s, in the next steps
//   });
#pragma once
#include <cstddef>
#include <memory>
#include <string>

#include "core/geometry/shapes/pose.hpp"
#include "io/simulation/simulation.hpp"

namespace thaw {

struct WallLoad;

/// Motion from now on: a pose and constant rates. The pose maps the shape of the scene, with its `place`:
/// x = position + R(rotation) x_scene.
struct ObstacleMotion {
  Vec3d position{};      ///< m
  Vec3d velocity{};      ///< m/s
  Vec3d rotation{};      ///< rad, about x, then y, then z
  Vec3d rotationRate{};  ///< rad/s, of the three angles
};

/// Load of all particles on an obstacle at the end of the last step, over all ranks: pressure, drag, contact
/// and surface tension (docs/theory/walls.md; core/walls/wall_load.hpp). It is the reaction to the forces on
/// the particles, so that momentum is conserved. Zero before the first step.
struct ObstacleLoad {
  Vec3d force{};   ///< N
  Vec3d torque{};  ///< N m, about the moved origin of the shape
};

/// Computes the load on one obstacle in each step, from its construction on. Requires: the simulation
/// outlives it and stays where it is in memory. All ranks make the same calls with the same values.
class DrivenObstacle {
 public:
  /// Throws std::invalid_argument for an unknown name, and for an obstacle without keyframes or shorter than
  /// a periodic domain. Also throws it for scenes with forces on obstacles that load() would lack.
  DrivenObstacle(Simulation& sim, const std::string& name);
  /// Replaces the motion of the scene from now on. After a restart, call it before the first step. Throws
  /// std::invalid_argument for values that are not finite.
  void move(const ObstacleMotion& motion);
  const Pose& pose() const;  ///< m, rad, at the time of the simulation
  /// Returns force and torque of the last step. Collective. The same bits on any number of ranks.
  ObstacleLoad load() const;

 private:
  Simulation* sim_;
  std::size_t wall_;                // index in the list
  std::shared_ptr<WallLoad> load_;  // part of this rank
};

}  // namespace thaw
