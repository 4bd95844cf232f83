// SPDX-License-Identifier: Apache-2.0
// Expressions of position in a scene file: "300 + 20*z", "-100*x".
#pragma once
#include <functional>
#include <string>

#include "core/math/vec3.hpp"

namespace thaw {

/// An expression of x, y, z. `value` returns the same bits for the same position on every rank and in any
/// locale. It must not be called by several threads at once. error: the error and its position in the text,
/// or "".
struct Expression {
  std::function<double(const Vec3d&)> value;
  std::string error;
};

/// Parses an expression with muParser. Never throws.
Expression parseExpression(const std::string& text);

/// Returns whether a text is meant as an expression, correct or not, and not as a quantity with a unit.
bool looksLikeExpression(const std::string& text);

/// Functions and constants of expressions, for the documentation.
extern const char* const expressionWords;

}  // namespace thaw
