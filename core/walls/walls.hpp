// SPDX-License-Identifier: Apache-2.0
// Obstacles and domain walls at run time, given by signed distances. Walls may move, and have a temperature
// or are insulating.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/shapes/pose.hpp"
#include "core/math/exact_sum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Wall {
  std::shared_ptr<const SignedDistance> shape;  ///< in the rest pose
  Obstacle properties;             ///< from the scene; domain sides have names like "domain z low"
  Bounds bounds;                   ///< in the rest pose
  Pose pose;                       ///< current pose
  bool present = true;             ///< false after properties.until
  Vec3d shift{};                   ///< m, whole periods of the domain, for images across periodic sides
  std::size_t imageOf = original;  ///< index in the list of the original wall

  static constexpr std::size_t original = ~std::size_t{0};
  bool isImage() const { return imageOf != original; }
  /// k: index of this wall in the list.
  std::size_t originalAt(std::size_t k) const { return isImage() ? imageOf : k; }
};

struct Walls {
  std::vector<Wall> list;
};

/// Adds a half-space for each wall side of the domain. It is insulating, has no slip for liquids, and a
/// friction of 0.3.
void addDomainWalls(const Domain& domain, Walls& walls);

/// Inserts the images of each obstacle across periodic sides behind the original. These are all images that
/// come within `reach` (m) of the domain as they move. Shapes at least as long as the domain along an axis
/// have no images along it. Call it once, on the complete list.
void addWallImages(const Domain& domain, double reach, Walls& walls);

/// Returns the axes ("x", "xy", ...) along which a shape differs within `reach` (m) of both periodic sides.
/// Such a shape is as long as the domain, and thus has no images.
std::string unevenAxes(const Domain& domain, const Wall& wall, double reach);

/// Sets poses at a time (s), linear between keyframes; expired obstacles are no longer present.
void moveWalls(Walls& walls, double time);

/// Velocity (m/s) of the wall at a position.
Vec3d wallVelocity(const Wall& wall, const Vec3d& x);

/// Returns true if a present wall contains a position deeper than a quarter of a spacing. Samples there are
/// invalid. spacing: m.
bool holdsSample(const Wall& wall, const Vec3d& x, double spacing);

/// Length of springs between walls and liquid, in spacings.
inline constexpr double springOfLiquid = 0.25;

/// Returns a position moved away from all present walls by `distance` (m) at least. In a narrower gap, the
/// distance is as large as a few moves allow. Walls that contain the position deeper than `distance` are
/// ignored.
Vec3d clearOfWalls(const Walls& walls, double distance, const Vec3d& x);

/// Contact of a particle with a wall. The shares exclude contributions of other walls, at corners and where
/// walls coincide.
struct WallContact {
  std::uint32_t row, wall;
  double distance;       ///< m, negative inside the wall
  Vec3d normal;          ///< out of the wall
  double share = 1;      ///< 1, factor of pressure and drag
  double heatShare = 1;  ///< 1, factor of heat; only walls with a temperature count
};

/// A particle that was moved out of a wall in this step.
struct Projection {
  std::uint32_t row;
  Vec3d moved;    ///< m
  Vec3d stopped;  ///< m/s, removed velocity into the wall
};

/// Contacts of owned particles within a support radius, by row and then by wall. Sums use this order. The
/// lists are reused in each step.
struct WallContacts {
  std::vector<WallContact> list;
  std::vector<Projection> projections;
  std::vector<std::uint32_t> reachable;  ///< walls within reach of the current cell
  std::vector<double> added;             ///< relative density added by each wall of the current particle
  ExactSum fast[3];                      ///< N, part of Ledger::wallForce that acts in every substep
  double stiffest = 0;  ///< 1/s, largest product of sound speed and wall's derivative of the relative
                        ///< density; limits the step
};

}  // namespace thaw
