// A shape made ready for questions: signed distance (negative inside), gradient, bounds. Thread-safe,
// immutable.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Bounds {
  Vec3d min{}, max{};
};
/// Does x lie within `reach` (m) of the box along each axis?
inline bool nearBounds(const Bounds& b, const Vec3d& x, double reach) {
  for (int a = 0; a < 3; a++)
    if (x[a] < b.min[a] - reach || x[a] > b.max[a] + reach) return false;
  return true;
}

/// Some of the places that insideAlong() has found inside or outside, for the lines after it; of one shape.
struct KnownSides {
  struct Place {
    Vec3d x;
    bool in = false;
  };
  std::array<Place, 8> place;
  std::size_t count = 0;  ///< that were ever noted; the oldest are overwritten
  void note(const Vec3d& x, bool in) { place[count++ % place.size()] = {x, in}; }
};

class SignedDistance {
 public:
  virtual ~SignedDistance() = default;
  /// Signed distance in m (exact, or for unions, differences and intersections possibly smaller in magnitude)
  /// and, where asked for, the unit gradient (outward). The gradient is defined everywhere; where it is not
  /// unique one is chosen, always the same.
  virtual double distance(const Vec3d& x, Vec3d* gradient = nullptr) const = 0;
  /// The same where |distance| < reach (m). Elsewhere any value with the sign of the distance and a magnitude
  /// between reach and the distance's, and any gradient of length 1 or 0. For a mesh this is many times
  /// faster.
  virtual double distanceWithin(const Vec3d& x, double reach, Vec3d* gradient = nullptr) const {
    (void)reach;
    return distance(x, gradient);
  }
  virtual bool inside(const Vec3d& x) const { return distance(x) < 0; }
  /// Of points that follow each other along a line, evenly: in[k] becomes 1 where inside(points[k]), else 0.
  /// For a mesh this is many times faster than asking point by point, the more so where `known` comes from
  /// lines near this one.
  virtual void insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                           KnownSides& known) const;
  virtual Bounds bounds() const = 0;  ///< HalfSpace: infinite
  /// Largest dot(direction, x) over the shape (or an upper bound of it); direction of any length. Infinite
  /// for most of a HalfSpace.
  virtual double extent(const Vec3d& direction) const;
  /// The same over all points outside the shape: infinite but for half-spaces.
  virtual double outerExtent(const Vec3d& direction) const;
  /// True where the shape is known to be convex: no point outside is near several of its faces.
  virtual bool convex() const { return false; }
  /// Can inside() change its answer within |distance| of a point? Only for soups of triangles that are not
  /// closed.
  virtual bool hasGaps() const { return false; }
  /// m^2, of the surface, where it is known without looking for it: of meshes; else negative.
  virtual double area() const { return -1; }
  /// Adds a sentence for everything that was mended in the shape's meshes, for the warnings of a run.
  virtual void addNotes(std::vector<std::string>& notes) const { (void)notes; }
};

/// Bounding box from six extents.
Bounds boundsFromExtents(const SignedDistance& shape);

/// Thrown for shapes and meshes that cannot be used (shape_error.hpp); what() says what was expected.
struct ShapeError;

/// Placement: with fitHeight, `scale` is set aside; with bottom, `move` is. The path "builtin:bust" names the
/// project's own bust (bust.hpp); all other meshes come from `load`. Throws ShapeError; what a loader throws
/// becomes one, with its message.
std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape, const MeshLoader& load = {});

class SceneProblems;
/// The same of a shape in a scene: where it cannot be used, the problem is added with its place and whose it
/// is ("body 'bust'"), and there is none.
std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape, const MeshLoader& load,
                                                         const std::string& whose, SceneProblems& problems);

}  // namespace thaw
