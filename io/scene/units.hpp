// Quantities with units: "2 kJ/kg", "15 cm", "56 degC", "0.25 W/(m K)", "30 deg".
#pragma once
#include <array>
#include <string>
#include <string_view>

namespace thaw {

/// Exponents of metre, kilogram, second, kelvin. Angles have none (rad = 1).
using Dimension = std::array<int, 4>;

struct Quantity {
  double value = 0;          ///< SI
  Dimension dimension{};
  bool hasUnit = false;
  std::string error;         ///< empty if all is well, else what is wrong
};

/// Reads a number and its unit: factors separated by spaces, '*' or '/', powers with '^', one pair of parentheses after '/', SI
/// prefixes. "degC" stands alone and becomes kelvin.
Quantity parseQuantity(std::string_view text);

/// The dimension of a unit as it stands in the table of keys, e.g. "kg/m^3"; "" and "1" have none.
Dimension dimensionOf(std::string_view unit);

}  // namespace thaw
