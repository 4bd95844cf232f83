// SPDX-License-Identifier: Apache-2.0
// Signed distance of a shape (negative inside), its gradient and bounds. Immutable and thread-safe.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Bounds {
  Vec3d min{}, max{};  ///< m
};
/// Returns true if x lies within `reach` (m) of the box along each axis.
inline bool nearBounds(const Bounds& b, const Vec3d& x, double reach) {
  for (int a = 0; a < 3; a++)
    if (x[a] < b.min[a] - reach || x[a] > b.max[a] + reach) return false;
  return true;
}

/// Recent results of insideAlong(), reused for later lines through the same shape.
struct KnownSides {
  struct Place {
    Vec3d x;
    bool in = false;
  };
  std::array<Place, 8> place;
  std::size_t count = 0;  ///< number of results recorded so far; the oldest are overwritten
  void note(const Vec3d& x, bool in) { place[count++ % place.size()] = {x, in}; }
};

class SignedDistance {
 public:
  virtual ~SignedDistance() = default;
  /// Returns the signed distance (m). It is exact, except that unions, differences and intersections may
  /// return a smaller magnitude. `gradient`, if given, receives the outward unit gradient. The gradient is
  /// defined everywhere. If it is not unique, the choice is deterministic.
  virtual double distance(const Vec3d& x, Vec3d* gradient = nullptr) const = 0;
  /// Equals distance() where |distance| < reach (m). Elsewhere, the value has the sign of the distance and a
  /// magnitude between reach and |distance|. The gradient has length 1 or 0. For meshes, this is many times
  /// faster than distance().
  virtual double distanceWithin(const Vec3d& x, double reach, Vec3d* gradient = nullptr) const {
    (void)reach;
    return distance(x, gradient);
  }
  virtual bool inside(const Vec3d& x) const { return distance(x) < 0; }
  /// Sets in[k] to inside(points[k]) for evenly spaced points (m) along a line. For meshes, this is many
  /// times faster than single queries, especially if `known` comes from nearby lines.
  virtual void insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                           KnownSides& known) const;
  virtual Bounds bounds() const = 0;  ///< HalfSpace: infinite
  /// Returns an upper bound of dot(direction, x) (m) over the shape, exact where possible. The direction has
  /// any length. The bound is infinite for most directions of a HalfSpace.
  virtual double extent(const Vec3d& direction) const;
  /// As extent(), but over all points outside the shape. Infinite except for half-spaces.
  virtual double outerExtent(const Vec3d& direction) const;
  /// Returns true if the shape is known to be convex, so no outside point is near several of its faces.
  virtual bool convex() const { return false; }
  /// Returns true if inside() may change within |distance| of a point. This is only possible for open sets of
  /// triangles.
  virtual bool hasGaps() const { return false; }
  /// Returns the surface area (m^2) if it is known without computation, as for meshes; else a negative
  /// number.
  virtual double area() const { return -1; }
  /// Adds one sentence for each repair of the shape's meshes, for the warnings of a run.
  virtual void addNotes(std::vector<std::string>& notes) const { (void)notes; }
};

/// Returns the bounding box (m) from six extents.
Bounds boundsFromExtents(const SignedDistance& shape);

/// Thrown for unusable shapes and meshes (shape_error.hpp); what() says what was expected.
struct ShapeError;

/// Creates the signed distance of a shape. fitHeight replaces `scale`, and bottom replaces `move`. The path
/// "builtin:bust" names the built-in bust (bust.hpp); all other meshes come from `load`. Throws ShapeError.
/// Errors of the loader become a ShapeError with the same message.
std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape, const MeshLoader& load = {});

class SceneProblems;
/// As above, for a shape in a scene. For an unusable shape, adds a problem with its position and owner ("body
/// 'bust'"), and returns null.
std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape, const MeshLoader& load,
                                                         const std::string& whose, SceneProblems& problems);

}  // namespace thaw
