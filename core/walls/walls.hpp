// Obstacles and the domain's walls as the step sees them: signed distances, moving, of a temperature or insulating.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/pose.hpp"
#include "core/geometry/signed_distance.hpp"
#include "core/math/exact_sum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Wall {
  std::shared_ptr<const SignedDistance> shape;  ///< at rest pose
  Obstacle properties;                          ///< of the scene; domain sides have a name like "domain z low"
  Bounds bounds;                                ///< of the rest pose
  Pose pose;                                    ///< now
  bool present = true;                          ///< false after properties.until
};

struct Walls {
  std::vector<Wall> list;
};

/// Adds a half-space for each side of the domain that is a wall: insulating, liquids stick, friction 0.3.
void addDomainWalls(const Domain& domain, Walls& walls);

/// Poses at a time (s), linear between keyframes; obstacles whose time is over are no longer present.
void moveWalls(Walls& walls, double time);

/// Velocity (m/s) of the wall at a place.
Vec3d wallVelocity(const Wall& wall, const Vec3d& x);

/// Does a present wall hold a place by more than a quarter of a spacing (m)? What is sampled there cannot begin.
bool holdsSample(const Wall& wall, const Vec3d& x, double spacing);

/// A particle near a wall. The shares leave out what another wall has filled already, at corners and where walls coincide.
struct WallContact {
  std::uint32_t row, wall;
  double distance;       ///< m, negative inside the wall
  Vec3d normal;          ///< out of the wall
  double share = 1;      ///< 1, of pressure and drag
  double heatShare = 1;  ///< 1, of heat: only walls with a temperature share it
};

/// Contacts of owned particles within a support radius, by row and then by wall: the order of sums. Reused in every step.
struct WallContacts {
  std::vector<WallContact> list;
  std::vector<std::uint32_t> reachable;  ///< walls that can be within reach of the cell at hand
  std::vector<double> added;             ///< filling that each wall of the particle at hand has added
  ExactSum fast[3];                      ///< N, of Ledger::wallForce that what takes substeps feels in each of them
  double stiffest = 0;                   ///< 1/s, largest sound speed times slope of the filling by a wall: bounds the step
};

}  // namespace thaw
