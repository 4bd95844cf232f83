// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/sharp_edge.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/mat3.hpp"

namespace thaw {
namespace {

constexpr double sameFace = 0.95;        // smallest cosine between normals of one face
constexpr double leastAngle = 0.3;       // smallest sine of the angle between faces, and smallest volume
                                         // spanned by three normals
constexpr double farthest = 2;           // spacings
constexpr double onSurface = 0.05;       // spacings, largest distance of an edge from the surface
constexpr double widths[] = {0.4, 0.8};  // spacings, distances of samples

constexpr double endsWithin = 1.65;  // spacings, distance up to which the ends of an edge are sought

constexpr std::size_t mostFaces = 6;  // more faces are parts of a curved surface

constexpr double beside = 0.2;       // spacings, distance from the edge at which its two faces are sampled
constexpr double straightFor = 0.6;  // spacings, length along an edge that is tested for curvature
constexpr double leastBend = 0.003;  // spacings; an edge that leaves its tangent by more is curved

/// Plane n . y = height of a face; y is relative to x.
struct FacePlane {
  Vec3d n{};
  double height = 0;  ///< m
};

/// Lists the faces that are nearest to samples around x, inside the shape.
std::vector<FacePlane> facesAround(const SignedDistance& shape, const Vec3d& x, double spacing) {
  std::vector<FacePlane> faces;
  Vec3d n;
  const double depth = -shape.distance(x, &n);
  const auto add = [&](const Vec3d& y) {
    Vec3d normal;
    const double d = shape.distance(x + y, &normal);
    if (!(d < 0)) return;
    for (const FacePlane& f : faces)
      if (dot(f.n, normal) > sameFace) return;
    faces.push_back({normal, dot(normal, y) - d});
  };
  // samples must fit inside
  const Vec3d base = -std::max(0.0, 0.5 * spacing - depth) * n;
  for (const double w : widths)
    for (int k = 0; k < 27; k++) {
      const Vec3d e{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
      add(base + (w * spacing) * normalized(e));
    }
  return faces;
}

/// Returns the point nearest to the origin on the line where two planes meet.
Vec3d meet(const FacePlane& a, const FacePlane& b) {
  const double c = dot(a.n, b.n), d = 1 - c * c;
  return ((a.height - c * b.height) / d) * a.n + ((b.height - c * a.height) / d) * b.n;
}

/// Returns the point where three planes meet.
Vec3d meet(const FacePlane& a, const FacePlane& b, const FacePlane& c) {
  return inverse(Mat3d{{a.n, b.n, c.n}}) * Vec3d{a.height, b.height, c.height};
}

/// Edge between two faces with the normals a and b. `to` (m) is a point of the edge, relative to x.
struct EdgeOfFaces {
  Vec3d to{}, a{}, b{};
  Vec3d along() const { return normalized(cross(a, b)); }
};

/// Returns the intersection of the planes that touch the faces next to the edge. For a face of radius R, its
/// error is then 0.02 spacing^2 / R.
EdgeOfFaces refined(const SignedDistance& shape, const Vec3d& x, EdgeOfFaces e, double spacing) {
  const auto faceBeside = [&](const Vec3d& own, const Vec3d& other) {
    const Vec3d at = e.to -
                     spacing * (beside * normalized(other - dot(own, other) * own) + 0.1 * beside * own);
    FacePlane f;
    const double d = shape.distance(x + at, &f.n);
    f.height = dot(f.n, at) - d;
    return f;
  };
  for (int pass = 0; pass < 2; pass++) {
    const FacePlane a = faceBeside(e.a, e.b), b = faceBeside(e.b, e.a);
    if (!(length(cross(a.n, b.n)) > leastAngle)) break;
    e.a = a.n, e.b = b.n;
    const Vec3d near = meet(a, b), along = e.along();
    e.to = near + dot(e.to - near, along) * along;
  }
  return e;
}

/// Returns true if an edge deviates from its tangent within the part that an element describes.
bool isCurved(const SignedDistance& shape, const Vec3d& edge, const Vec3d& along, double spacing) {
  const double s = straightFor * spacing, least = shape.distance(edge, nullptr) + leastBend * spacing;
  return shape.distance(edge + s * along, nullptr) > least &&
         shape.distance(edge - s * along, nullptr) > least;
}

/// Returns the distance (m) from a point of an edge to its end in a direction. It is infinite if the end is
/// not near.
double endAlong(const SignedDistance& shape, const Vec3d& edge, const Vec3d& direction, double spacing) {
  double at = endsWithin * spacing;
  // The distance from the surface is at most the distance from the end.
  for (int k = 0; k < 4; k++) {
    const double off = std::abs(shape.distance(edge + at * direction, nullptr));
    if (off < onSurface * spacing) return k == 0 ? HUGE_VAL : at;
    at = std::max(0.0, at - off);
  }
  return at;
}

}  // namespace

SharpEdge sharpEdge(const SignedDistance& shape, const Vec3d& x, double spacing) {
  const std::vector<FacePlane> f = facesAround(shape, x, spacing);
  if (f.size() > mostFaces) return {};
  EdgeOfFaces edge;
  Vec3d& best = edge.to;
  const auto nearer = [&](const Vec3d& y) { return best == Vec3d{} || dot(y, y) < dot(best, best); };
  const auto lies = [&](const Vec3d& y) {
    return length(y) < farthest * spacing && std::abs(shape.distance(x + y, nullptr)) < onSurface * spacing;
  };
  const auto convex = [&](const FacePlane& a, const FacePlane& b, const Vec3d& y) {
    return shape.distance(x + y + 0.1 * spacing * normalized(a.n - b.n), nullptr) > 0;
  };
  for (std::size_t a = 0; a < f.size(); a++)
    for (std::size_t b = a + 1; b < f.size(); b++)
      for (std::size_t c = b + 1; c < f.size(); c++) {
        if (std::abs(dot(f[a].n, cross(f[b].n, f[c].n))) < leastAngle) continue;
        if (const Vec3d y = meet(f[a], f[b], f[c]); nearer(y) && lies(y)) best = y;
      }
  if (!(best == Vec3d{})) return {best};
  for (std::size_t a = 0; a < f.size(); a++)
    for (std::size_t b = a + 1; b < f.size(); b++) {
      if (length(cross(f[a].n, f[b].n)) < leastAngle) continue;
      const Vec3d y = meet(f[a], f[b]);
      if (!nearer(y) || !lies(y) || !convex(f[a], f[b], y)) continue;
      edge = {y, f[a].n, f[b].n};
    }
  if (best == Vec3d{}) return {};
  edge = refined(shape, x, edge, spacing);
  const Vec3d at = x + edge.to, along = edge.along();
  if (isCurved(shape, at, along, spacing)) return {edge.to};
  return {edge.to, along, endAlong(shape, at, along, spacing), endAlong(shape, at, -along, spacing)};
}

}  // namespace thaw
