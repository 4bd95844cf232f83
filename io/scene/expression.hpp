// Expressions of position in a scene file: "300 + 20*z", "-100*x".
#pragma once
#include <functional>
#include <string>

#include "core/math/vec3.hpp"

namespace thaw {

/// An expression of x, y, z. `value` gives the same bits for the same place on every rank and in any locale;
/// it is not to be called by several threads at once. error: what is wrong, and where in the text; or empty.
struct Expression {
  std::function<double(const Vec3d&)> value;
  std::string error;
};

/// Reads it with muParser. Never throws.
Expression parseExpression(const std::string& text);

/// Is the text meant as an expression, right or wrong, and not as a quantity with a unit?
bool looksLikeExpression(const std::string& text);

/// The functions and constants of expressions, for the documentation.
extern const char* const expressionWords;

}  // namespace thaw
