// Quantities of the start as functions of position, which are made by io/scene/expression.hpp.
#pragma once
#include <functional>
#include <string>

#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

/// A scalar field, in SI units, of a position (m) in the frame of the scene.
struct PositionField {
  std::string text;  // as the scene has it
  std::string key;   // path of its key, for messages
  SourcePlace where;
  std::function<double(const Vec3d&)> value;  // empty: no field; not to be called by several threads at once
  explicit operator bool() const { return static_cast<bool>(value); }
};

/// v(x) = component(x) + gradient (x - centre), on top of a uniform velocity. centre: the middle of the
/// bounding box of a body, or of the opening of an emitter.
struct VelocityField {
  PositionField component[3];
  Mat3d gradient{};  // 1/s, [i][j]: d v_i / d x_j
  SourcePlace gradientWhere;
  bool linear = false;  // a gradient is given
  bool given() const { return linear || component[0] || component[1] || component[2]; }
};

/// m/s, of a field at x (m); centre: see VelocityField.
Vec3d velocityOf(const VelocityField& field, const Vec3d& centre, const Vec3d& x);

/// The beginning of a sentence on a field with a bad value at x (m).
std::string badValue(const PositionField& field, double value, const Vec3d& x);

}  // namespace thaw
