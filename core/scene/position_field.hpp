// SPDX-License-Identifier: Apache-2.0
// Initial values as functions of position, created by io/scene/text/expression.hpp.
#pragma once
#include <functional>
#include <string>

#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

/// A scalar field in SI units as a function of position (m) in the scene's frame.
struct PositionField {
  std::string text;  // source text
  std::string key;   // path of its key, for messages
  SourcePlace where;
  std::function<double(const Vec3d&)> value;  // empty: no field. Not thread-safe
  explicit operator bool() const { return static_cast<bool>(value); }
};

/// Velocity (m/s) v(x) = component(x) + gradient (x - centre), added to a uniform velocity. centre: m,
/// centre of a body's bounding box, or of an emitter's opening.
struct VelocityField {
  PositionField component[3];
  Mat3d gradient{};  // 1/s, [i][j]: d v_i / d x_j
  SourcePlace gradientWhere;
  bool linear = false;  // a gradient is given
  bool given() const { return linear || component[0] || component[1] || component[2]; }
};

/// Returns the velocity (m/s) of a field at x (m). centre: m, see VelocityField.
Vec3d velocityOf(const VelocityField& field, const Vec3d& centre, const Vec3d& x);

/// Returns the first part of an error message about a bad field value at x (m).
std::string badValue(const PositionField& field, double value, const Vec3d& x);

}  // namespace thaw
