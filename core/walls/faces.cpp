// SPDX-License-Identifier: Apache-2.0
#include "core/walls/faces.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

/// Cosine between normals above which two faces are the same.
constexpr double sameDirection = 0.98;

/// Returns the face nearest to a point `probe` near x.
Face faceFrom(const SignedDistance& shape, const Vec3d& x, const Vec3d& probe) {
  Face f;
  const double d = shape.distance(probe, &f.normal);
  f.distance = d + dot(x - probe, f.normal);
  return f;
}

bool isKnown(const Faces& known, const Face& f) {
  return std::any_of(known.face.begin(), known.face.begin() + static_cast<std::ptrdiff_t>(known.count),
                     [&](const Face& k) { return dot(k.normal, f.normal) > sameDirection; });
}

/// Returns true if the projection of x onto the face lies on the surface. First x is moved out of the other
/// faces. Otherwise, for x below a floor, the projection onto a side wall would be inside the wall.
bool isSurface(const SignedDistance& shape, const Vec3d& x, const Faces& known, const Face& f,
               double spacing) {
  Vec3d lifted = x;
  for (std::size_t k = 0; k < known.count; k++)
    lifted += known.face[k].normal * std::max(0.0, 0.5 * spacing - known.face[k].distance);
  const double tolerance = 0.05 * spacing;
  const double height = f.distance + dot(lifted - x, f.normal);
  return std::abs(shape.distanceWithin(lifted - f.normal * height, 2 * tolerance)) < tolerance;
}

/// Searches for another face near x + step. Returns true if it adds one.
bool addFace(const SignedDistance& shape, const Vec3d& x, const Vec3d& step, Faces& faces, double reach,
             double spacing) {
  const Face f = faceFrom(shape, x, x + step);
  if (!(f.distance < reach && f.distance > -spacing) || isKnown(faces, f)) return false;
  if (!isSurface(shape, x, faces, f, spacing)) return false;
  faces.face[faces.count++] = f;
  return true;
}

/// Returns a unit vector perpendicular to n.
Vec3d perpendicular(const Vec3d& n) {
  const Vec3d axis = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  return normalized(cross(n, axis));
}

/// Finds directions away from the known faces, with a component of 1 along the normals of these faces.
/// Between opposite faces, directions are parallel to the faces. Returns their number.
std::size_t awayFrom(const Faces& known, std::array<Vec3d, 4>& direction) {
  constexpr double opposite = -0.9;
  const Vec3d& a = known.face[0].normal;
  if (known.count == 1) {
    direction[0] = a;
    return 1;
  }
  const Vec3d& b = known.face[1].normal;
  const double c = dot(a, b);
  if (c > opposite) {
    direction[0] = (a + b) * (1 / (1 + c));
    return 1;
  }
  const Vec3d t = perpendicular(a), s = cross(a, t);
  direction = {t, -t, s, -s};
  return 4;
}

}  // namespace

Faces facesWithin(const SignedDistance& shape, const Vec3d& x, double reach, double spacing) {
  Faces faces;
  Face& first = faces.face[0];
  first.distance = shape.distance(x, &first.normal);
  if (!(first.distance < reach)) return faces;
  faces.count = 1;
  if (shape.convex()) return faces;
  // At distance `reach` from the known faces, an unknown face is the nearest. A narrow gap needs a shorter
  // distance.
  for (bool found = true; found && faces.count < Faces::most;) {
    found = false;
    std::array<Vec3d, 4> direction;
    const std::size_t directions = awayFrom(faces, direction);
    for (std::size_t k = 0; k < directions && !found; k++)
      for (const double share : {1.0, 0.5})
        if (!found) found = addFace(shape, x, direction[k] * (share * reach), faces, reach, spacing);
  }
  return faces;
}

}  // namespace thaw
