// A shape made ready for questions: signed distance (negative inside), gradient, bounds. Thread-safe, immutable.
#pragma once
#include <memory>
#include <string>

#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Bounds { Vec3d min{}, max{}; };

class SignedDistance {
 public:
  virtual ~SignedDistance() = default;
  /// Signed distance in m (exact, or for differences and intersections a lower bound of the absolute value) and, where asked
  /// for, the unit gradient (outward).
  virtual double distance(const Vec3d& x, Vec3d* gradient = nullptr) const = 0;
  virtual bool inside(const Vec3d& x) const { return distance(x) < 0; }
  virtual Bounds bounds() const = 0;  ///< HalfSpace: infinite
};

/// Thrown for shapes and meshes that cannot be used; what() says what was expected.
struct ShapeError;

std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape);

}  // namespace thaw
