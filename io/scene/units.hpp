// Quantities with units: "2 kJ/kg", "15 cm", "56 degC", "0.25 W/(m K)", "30 deg", "2 Pa s".
#pragma once
#include <array>
#include <string>
#include <string_view>

namespace thaw {

/// Exponents of metre, kilogram, second, kelvin and radian. The radian counts, so that an angular velocity is
/// no frequency.
using Dimension = std::array<int, 5>;

struct Quantity {
  double value = 0;  ///< SI
  Dimension dimension{};
  bool hasUnit = false;  ///< a bare number has none and stands for any dimension
  std::string error;     ///< empty if all is well, else what is wrong
};

/// Reads a number and its unit: factors separated by spaces, '*' or '/', powers with '^', parentheses, SI
/// prefixes. A '/' divides by the next factor alone: "W/m K" is W K/m. "degC" stands alone and becomes
/// kelvin. Decimal factors divide rather than multiply, so that "7 cm" is the double nearest to 0.07. Never
/// throws; what is wrong is in `error`.
Quantity parseQuantity(std::string_view text);

/// The dimension of a unit as it stands in the table of keys, e.g. "kg/m^3"; "" and "1" have none.
Dimension dimensionOf(std::string_view unit);

/// What a quantity of a unit of the table of keys is called in messages, with an example: `a length such as
/// "2 mm"`.
std::string kindOfUnit(std::string_view unit);

}  // namespace thaw
