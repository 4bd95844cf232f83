// SPDX-License-Identifier: Apache-2.0
// Quantities with units: "2 kJ/kg", "15 cm", "56 degC", "0.25 W/(m K)", "30 deg", "2 Pa s".
#pragma once
#include <array>
#include <string>
#include <string_view>

namespace thaw {

/// Exponents of metre, kilogram, second, kelvin and radian. The radian counts as a dimension, which
/// distinguishes an angular velocity from a frequency.
using Dimension = std::array<int, 5>;

/// Error of a text that does not begin with a number.
inline constexpr const char* missingNumber = "a number is missing";

struct Quantity {
  double value = 0;  ///< SI
  Dimension dimension{};
  bool hasUnit = false;  ///< a number without unit fits any dimension
  std::string error;     ///< the error, or ""
};

/// Reads a number and its unit: factors separated by spaces, '*' or '/', powers with '^', parentheses, SI
/// prefixes. A '/' divides by the next factor alone: "W/m K" is W K/m. "degC" must stand alone and becomes
/// kelvin. Decimal factors divide rather than multiply, so that "7 cm" is the double nearest to 0.07. Never
/// throws; sets `error`.
Quantity parseQuantity(std::string_view text);

/// Returns the dimension of a unit of the table of keys, such as "kg/m^3"; "" and "1" have none.
Dimension dimensionOf(std::string_view unit);

/// Returns the name of a quantity of a unit in messages, with an example: `a length such as "2 mm"`.
std::string kindOfUnit(std::string_view unit);

}  // namespace thaw
