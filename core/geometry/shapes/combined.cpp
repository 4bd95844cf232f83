// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/combined.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace thaw {

double CombinedDistance::distanceWithin(const Vec3d& x, double reach, Vec3d* gradient) const {
  const bool smallest = kind_ == Kind::Union;
  double d = smallest ? never : -never;
  for (std::size_t k = 0; k < parts_.size(); k++) {
    const bool turned = kind_ == Kind::Difference && k > 0;
    Vec3d g;
    double v = parts_[k]->distanceWithin(x, reach, gradient ? &g : nullptr);
    if (turned) v = -v, g = -g;
    if (smallest ? v < d : v > d) {
      d = v;
      if (gradient) *gradient = g;
    }
  }
  return d;
}

bool CombinedDistance::inside(const Vec3d& x) const {
  switch (kind_) {
    case Kind::Union:
      return std::any_of(parts_.begin(), parts_.end(), [&](const ShapePart& p) { return p->inside(x); });
    case Kind::Intersection:
      return std::all_of(parts_.begin(), parts_.end(), [&](const ShapePart& p) { return p->inside(x); });
    case Kind::Difference: break;
  }
  return parts_[0]->inside(x) &&
         std::none_of(parts_.begin() + 1, parts_.end(), [&](const ShapePart& p) { return p->inside(x); });
}

double CombinedDistance::extent(const Vec3d& direction) const {
  double e = parts_[0]->extent(direction);
  for (std::size_t k = 1; k < parts_.size(); k++) {
    if (kind_ == Kind::Union) e = std::max(e, parts_[k]->extent(direction));
    if (kind_ == Kind::Intersection) e = std::min(e, parts_[k]->extent(direction));
    if (kind_ == Kind::Difference) e = std::min(e, parts_[k]->outerExtent(direction));
  }
  return e;
}

bool CombinedDistance::convex() const {
  return kind_ == Kind::Intersection &&
         std::all_of(parts_.begin(), parts_.end(), [](const ShapePart& p) { return p->convex(); });
}

bool CombinedDistance::hasGaps() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const ShapePart& p) { return p->hasGaps(); });
}

void CombinedDistance::addNotes(std::vector<std::string>& notes) const {
  for (const ShapePart& p : parts_) p->addNotes(notes);
}

bool isIdentity(const Mat3d& m) {
  const Mat3d one = identity3<double>();
  return m.row[0] == one.row[0] && m.row[1] == one.row[1] && m.row[2] == one.row[2];
}

PlacedDistance::PlacedDistance(ShapePart part, const Placement& placement)
    : part_(std::move(part)), placement_(placement), back_(transpose(placement.rotation)) {
  rotated_ = !isIdentity(placement.rotation);
  bounds_ = boundsFromExtents(*this);
}

Vec3d PlacedDistance::toPart(const Vec3d& x) const {
  const Vec3d y = x - placement_.move;
  return (rotated_ ? back_ * y : y) / placement_.scale;
}

double PlacedDistance::distance(const Vec3d& x, Vec3d* gradient) const {
  const double d = part_->distance(toPart(x), gradient);
  if (gradient && rotated_) *gradient = placement_.rotation * *gradient;
  return d * placement_.scale;
}

void PlacedDistance::insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                                 KnownSides& known) const {
  constexpr std::size_t pointsAtOnce = 256;
  std::array<Vec3d, pointsAtOnce> placed;
  for (std::size_t first = 0; first < points.size(); first += pointsAtOnce) {
    const std::size_t n = std::min(points.size() - first, pointsAtOnce);
    for (std::size_t k = 0; k < n; k++) placed[k] = toPart(points[first + k]);
    part_->insideAlong({placed.data(), n}, in.subspan(first, n), known);
  }
}

double PlacedDistance::distanceWithin(const Vec3d& x, double reach, Vec3d* gradient) const {
  const double d = part_->distanceWithin(toPart(x), reach / placement_.scale, gradient);
  if (gradient && rotated_) *gradient = placement_.rotation * *gradient;
  return d * placement_.scale;
}

double PlacedDistance::extent(const Vec3d& n) const {
  return dot(n, placement_.move) + placement_.scale * part_->extent(rotated_ ? back_ * n : n);
}

double PlacedDistance::outerExtent(const Vec3d& n) const {
  return dot(n, placement_.move) + placement_.scale * part_->outerExtent(rotated_ ? back_ * n : n);
}

Mat3d axesOf(const SignedDistance& shape) {
  const auto* placed = dynamic_cast<const PlacedDistance*>(&shape);
  return placed ? placed->rotation() : identity3<double>();
}

Mat3d rotationXyz(const Vec3d& a) {
  const double cx = std::cos(a.x), sx = std::sin(a.x), cy = std::cos(a.y), sy = std::sin(a.y),
               cz = std::cos(a.z), sz = std::sin(a.z);
  const Mat3d x{{{1, 0, 0}, {0, cx, -sx}, {0, sx, cx}}}, y{{{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}}},
      z{{{cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1}}};
  return z * (y * x);
}

}  // namespace thaw
