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
  Vec3d min{}, max{};
};
/// Returns true if x lies within `reach` (m) of the box along each axis.
inline bool nearBounds(const Bounds& b, const Vec3d& x, double reach) {
  for (int a = 0; a < 3; a++)
    if (x[a] < b.min[a] - reach || x[a] > b.max[a] + reach) return false;
  return true;
}

/// Recent results of insideAlong(), reused for later lines of the same shape.
struct KnownSides {
  struct Place {
    Vec3d x;
    bool in = false;
  };
  std::array<Place, 8> place;
  std::size_t count = 0;  ///< number ever recorded; the oldest are overwritten
  void note(const Vec3d& x, bool in) { place[count++ % place.size()] = {x, in}; }
};

class SignedDistance {
 public:
  virtual ~SignedDistance() = default;
  /// Returns the signed distance (m). It is exact, except that unions, differences and intersections may
  /// return a smaller magnitude. `gradient`, if given, receives the outward unit gradient. It is defined
  /// everywhere; where it is not unique, the choice is deterministic.
  virtual double distance(const Vec3d& x, Vec3d* gradient = nullptr) const = 0;
  /// Equals distance() where |distance| < reach (m). Elsewhere the value has the sign of the distance and a
  /// magnitude between reach and |distance|. The gradient has length 1 or 0. For meshes it is many times
  /// faster.
  virtual double distanceWithin(const Vec3d& x, double reach, Vec3d* gradient = nullptr) const {
    (void)reach;
    return distance(x, gradient);
  }
  virtual bool inside(const Vec3d& x) const { return distance(x) < 0; }
  /// Sets in[k] to inside(points[k]) for evenly spaced points along a line. For meshes it is many times
  /// faster than single queries, most of all if `known` comes from nearby lines.
  virtual void insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                           KnownSides& known) const;
  virtual Bounds bounds() const = 0;  ///< HalfSpace: infinite
  /// Returns an upper bound of dot(direction, x) over the shape, exact where possible; direction of any
  /// length. Infinite for most directions of a HalfSpace.
  virtual double extent(const Vec3d& direction) const;
  /// As extent(), over all points outside the shape: infinite except for half-spaces.
  virtual double outerExtent(const Vec3d& direction) const;
  /// Returns true if the shape is known to be convex: no outside point is near several of its faces.
  virtual bool convex() const { return false; }
  /// Returns true if inside() may change within |distance| of a point: only for open sets of triangles.
  virtual bool hasGaps() const { return false; }
  /// Surface area (m^2) if known at no cost, as for meshes; else negative.
  virtual double area() const { return -1; }
  /// Adds one sentence for each repair of the shape's meshes, for the warnings of a run.
  virtual void addNotes(std::vector<std::string>& notes) const { (void)notes; }
};

/// Bounding box from six extents.
Bounds boundsFromExtents(const SignedDistance& shape);

/// Thrown for unusable shapes and meshes (shape_error.hpp); what() says what was expected.
struct ShapeError;

/// Makes the signed distance of a shape. fitHeight replaces `scale`, and bottom replaces `move`. The path
/// "builtin:bust" names the built-in bust (bust.hpp); all other meshes come from `load`. Throws ShapeError,
/// also for errors of the loader, with their message.
std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape, const MeshLoader& load = {});

class SceneProblems;
/// As above for a shape in a scene. An unusable shape adds a problem with its place and owner ("body 'bust'")
/// and returns null.
std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape, const MeshLoader& load,
                                                         const std::string& whose, SceneProblems& problems);

}  // namespace thaw
