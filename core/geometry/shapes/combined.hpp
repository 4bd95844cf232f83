// SPDX-License-Identifier: Apache-2.0
// Union, difference, intersection and placement of shapes.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/mat3.hpp"

namespace thaw {

using ShapePart = std::shared_ptr<const SignedDistance>;

/// For unions, the distance is the minimum over the parts, else the maximum of side * distance. The value is
/// exact outside of unions, and inside of differences and intersections. Elsewhere, its magnitude is a lower
/// bound. Of parts with equal values, the first one gives the gradient.
class CombinedDistance final : public SignedDistance {
 public:
  enum class Kind { Union, Difference, Intersection };
  CombinedDistance(Kind kind, std::vector<ShapePart> parts)
      : kind_(kind), parts_(std::move(parts)), bounds_(boundsFromExtents(*this)) {}
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override {
    return distanceWithin(x, never, gradient);
  }
  double distanceWithin(const Vec3d& x, double reach, Vec3d* gradient = nullptr) const override;
  bool inside(const Vec3d& x) const override;
  Bounds bounds() const override { return bounds_; }
  double extent(const Vec3d& direction) const override;
  bool convex() const override;
  bool hasGaps() const override;
  void addNotes(std::vector<std::string>& notes) const override;

 private:
  Kind kind_;
  std::vector<ShapePart> parts_;
  Bounds bounds_;
};

/// x = move + rotation * (scale * x_part).
struct Placement {
  double scale = 1;
  Mat3d rotation = identity3<double>();
  Vec3d move{};  ///< m
};

/// Returns the placement of `part`, the shape without its placement. Throws ShapeError.
Placement placementOf(const Shape& shape, const ShapePart& part);

class PlacedDistance final : public SignedDistance {
 public:
  PlacedDistance(ShapePart part, const Placement& placement);
  double distance(const Vec3d& x, Vec3d* gradient = nullptr) const override;
  double distanceWithin(const Vec3d& x, double reach, Vec3d* gradient = nullptr) const override;
  bool inside(const Vec3d& x) const override { return part_->inside(toPart(x)); }
  void insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                   KnownSides& known) const override;
  Bounds bounds() const override { return bounds_; }
  double extent(const Vec3d& direction) const override;
  double outerExtent(const Vec3d& direction) const override;
  bool convex() const override { return part_->convex(); }
  bool hasGaps() const override { return part_->hasGaps(); }
  double area() const override { return part_->area() * placement_.scale * placement_.scale; }
  void addNotes(std::vector<std::string>& notes) const override { part_->addNotes(notes); }
  const Mat3d& rotation() const { return placement_.rotation; }

 private:
  Vec3d toPart(const Vec3d& x) const;
  ShapePart part_;
  Placement placement_;
  Mat3d back_;            ///< inverse of the rotation
  bool rotated_ = false;  ///< false: no rotation is applied, so unrotated shapes keep their bits
  Bounds bounds_;
};

bool isIdentity(const Mat3d& matrix);

/// Returns the axes of a shape in the scene, as columns: the rotation of its own placement.
Mat3d axesOf(const SignedDistance& shape);

/// Returns the rotation about x, then y, then z by these angles (rad): R = Rz Ry Rx.
Mat3d rotationXyz(const Vec3d& angles);

}  // namespace thaw
