// SPDX-License-Identifier: Apache-2.0
// Exact signed distances of simple solids, each in its own frame (scene.hpp). Sizes in m.
#pragma once
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"

namespace thaw {

class BoxDistance final : public SignedDistance {
 public:
  explicit BoxDistance(const Vec3d& size) : half_(0.5 * size) {}
  /// The gradient inside points towards the nearest face. Ties go to x, then y, then z.
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;
  Bounds bounds() const override { return {-half_, half_}; }
  bool convex() const override { return true; }

 private:
  Vec3d half_;
};

class SphereDistance final : public SignedDistance {
 public:
  explicit SphereDistance(double radius) : radius_(radius) {}
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;  ///< gradient at the centre: +x
  Bounds bounds() const override { return {{-radius_, -radius_, -radius_}, {radius_, radius_, radius_}}; }
  double extent(const Vec3d& direction) const override { return radius_ * length(direction); }
  bool convex() const override { return true; }

 private:
  double radius_;
};

class TorusDistance final : public SignedDistance {
 public:
  TorusDistance(double ring, double tube) : ring_(ring), tube_(tube) {}  ///< ring around z
  /// On the axis, the gradient points away from the ring's point on +x. On the ring, it points outward.
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;
  Bounds bounds() const override { return boundsFromExtents(*this); }
  double extent(const Vec3d& direction) const override;

 private:
  double ring_, tube_;
};

class HalfSpaceDistance final : public SignedDistance {
 public:
  HalfSpaceDistance(const Vec3d& point, const Vec3d& normal)
      : normal_(normalized(normal)), offset_(dot(normal_, point)) {}
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;
  Bounds bounds() const override { return {{-never, -never, -never}, {never, never, never}}; }
  double extent(const Vec3d& direction) const override { return alongNormal(direction, normal_, offset_); }
  double outerExtent(const Vec3d& direction) const override {
    return alongNormal(direction, -normal_, -offset_);
  }
  bool convex() const override { return true; }

 private:
  static double alongNormal(const Vec3d& direction, const Vec3d& normal, double offset);
  Vec3d normal_;
  double offset_;  ///< dot(normal, x) on the plane
};

/// Solid of revolution about z. The outline in the half-plane (distance from the axis, z) consists of
/// straight pieces with the solid on their left. The outline begins and ends on the axis.
class RevolvedDistance final : public SignedDistance {
 public:
  struct Point {
    double r, z;
  };
  explicit RevolvedDistance(std::vector<Point> outline);
  /// On the axis, +x is the radial direction. Of equally near pieces, the first one gives the gradient.
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;
  Bounds bounds() const override { return boundsFromExtents(*this); }
  double extent(const Vec3d& direction) const override;
  bool convex() const override { return convex_; }

 private:
  std::vector<Point> outline_;
  bool convex_;
};

/// Returns the outline of a cylinder (m) centred on the origin.
std::vector<RevolvedDistance::Point> cylinderOutline(double radius, double height);
/// Returns the outline of a glass (m) that stands on z = 0 and is open at the top. thickness: of wall and
/// floor.
std::vector<RevolvedDistance::Point> glassOutline(double radius, double height, double thickness);

}  // namespace thaw
