// Obstacles and the domain's walls as the step sees them: signed distances, moving, of a temperature or
// insulating.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/pose.hpp"
#include "core/geometry/signed_distance.hpp"
#include "core/math/exact_sum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Wall {
  std::shared_ptr<const SignedDistance> shape;  ///< at rest pose
  Obstacle properties;             ///< of the scene; domain sides have a name like "domain z low"
  Bounds bounds;                   ///< of the rest pose
  Pose pose;                       ///< now
  bool present = true;             ///< false after properties.until
  Vec3d shift{};                   ///< m, whole periods of the domain; of images across periodic sides
  std::size_t imageOf = original;  ///< place in the list of the wall that this is an image of

  static constexpr std::size_t original = ~std::size_t{0};
  bool isImage() const { return imageOf != original; }
  /// k: own place in the list
  std::size_t originalAt(std::size_t k) const { return isImage() ? imageOf : k; }
};

struct Walls {
  std::vector<Wall> list;
};

/// Adds a half-space for each side of the domain that is a wall: insulating, liquids stick, friction 0.3.
void addDomainWalls(const Domain& domain, Walls& walls);

/// Puts images of the obstacles in the list behind them, across the periodic sides of the domain: all that
/// come within `reach` (m) of it as they move. A shape as long as the domain, or without end, has none along
/// that axis. Call it once, when the list is complete.
void addWallImages(const Domain& domain, double reach, Walls& walls);

/// Axes ("x", "xy", ...) along which a shape that is as long as the domain, and so has no images, is not the
/// same within `reach` (m) of both periodic sides.
std::string unevenAxes(const Domain& domain, const Wall& wall, double reach);

/// Poses at a time (s), linear between keyframes; obstacles whose time is over are no longer present.
void moveWalls(Walls& walls, double time);

/// Velocity (m/s) of the wall at a place.
Vec3d wallVelocity(const Wall& wall, const Vec3d& x);

/// Does a present wall hold a place by more than a quarter of a spacing (m)? What is sampled there cannot
/// begin.
bool holdsSample(const Wall& wall, const Vec3d& x, double spacing);

/// A particle near a wall. The shares leave out what another wall has filled already, at corners and where
/// walls coincide.
struct WallContact {
  std::uint32_t row, wall;
  double distance;       ///< m, negative inside the wall
  Vec3d normal;          ///< out of the wall
  double share = 1;      ///< 1, of pressure and drag
  double heatShare = 1;  ///< 1, of heat: only walls with a temperature share it
};

/// Contacts of owned particles within a support radius, by row and then by wall: the order of sums. Reused in
/// every step.
struct WallContacts {
  std::vector<WallContact> list;
  std::vector<std::uint32_t> reachable;  ///< walls that can be within reach of the cell at hand
  std::vector<double> added;             ///< filling that each wall of the particle at hand has added
  ExactSum fast[3];     ///< N, of Ledger::wallForce that what takes substeps feels in each of them
  double stiffest = 0;  ///< 1/s, largest sound speed times slope of the filling by a wall: bounds the step
};

}  // namespace thaw
