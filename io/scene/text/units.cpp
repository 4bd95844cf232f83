// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/units.hpp"

#include <cctype>
#include <charconv>
#include <cstdlib>
#include <numbers>

namespace thaw {
namespace {

/// numerator / denominator is the factor to SI. Both are exact doubles for decimal factors.
struct Factor {
  double numerator = 1, denominator = 1;
};
struct Unit {
  std::string_view name;
  Factor factor;
  Dimension dimension;
  bool prefixes;
};
struct Prefix {
  std::string_view name;
  Factor factor;
};

using std::numbers::pi;
constexpr Unit units[] = {{"m", {1, 1}, {1, 0, 0, 0, 0}, true},
                          {"g", {1, 1000}, {0, 1, 0, 0, 0}, true},
                          {"s", {1, 1}, {0, 0, 1, 0, 0}, true},
                          {"K", {1, 1}, {0, 0, 0, 1, 0}, true},
                          {"N", {1, 1}, {1, 1, -2, 0, 0}, true},
                          {"Pa", {1, 1}, {-1, 1, -2, 0, 0}, true},
                          {"J", {1, 1}, {2, 1, -2, 0, 0}, true},
                          {"W", {1, 1}, {2, 1, -3, 0, 0}, true},
                          {"Hz", {1, 1}, {0, 0, -1, 0, 0}, true},
                          {"l", {1, 1000}, {3, 0, 0, 0, 0}, true},
                          {"L", {1, 1000}, {3, 0, 0, 0, 0}, true},
                          {"bar", {1e5, 1}, {-1, 1, -2, 0, 0}, true},
                          {"P", {1, 10}, {-1, 1, -1, 0, 0}, true},
                          {"t", {1000, 1}, {0, 1, 0, 0, 0}, false},
                          {"min", {60, 1}, {0, 0, 1, 0, 0}, false},
                          {"h", {3600, 1}, {0, 0, 1, 0, 0}, false},
                          {"rad", {1, 1}, {0, 0, 0, 0, 1}, true},
                          {"deg", {pi, 180}, {0, 0, 0, 0, 1}, false},
                          {"turn", {2 * pi, 1}, {0, 0, 0, 0, 1}, false},
                          {"rpm", {2 * pi, 60}, {0, 0, -1, 0, 1}, false},
                          {"%", {1, 100}, {}, false},
                          {"1", {1, 1}, {}, false},
                          {"in", {254, 10000}, {1, 0, 0, 0, 0}, false}};
constexpr Prefix prefixes[] = {{"da", {10, 1}},        {"n", {1, 1e9}},        {"u", {1, 1e6}},
                               {"\xc2\xb5", {1, 1e6}}, {"\xce\xbc", {1, 1e6}}, {"m", {1, 1e3}},
                               {"c", {1, 100}},        {"d", {1, 10}},         {"h", {100, 1}},
                               {"k", {1e3, 1}},        {"M", {1e6, 1}},        {"G", {1e9, 1}}};

bool findUnit(std::string_view name, Factor& factor, Dimension& dimension) {
  for (const Unit& u : units)
    if (u.name == name) return factor = u.factor, dimension = u.dimension, true;
  for (const Prefix& p : prefixes)
    if (name.size() > p.name.size() && name.substr(0, p.name.size()) == p.name)
      for (const Unit& u : units)
        if (u.prefixes && u.name == name.substr(p.name.size())) {
          factor = {p.factor.numerator * u.factor.numerator, p.factor.denominator * u.factor.denominator};
          return dimension = u.dimension, true;
        }
  return false;
}

/// Removes a prefix from a text. Returns false if the text does not begin with it.
bool take(std::string_view& t, std::string_view what) {
  if (t.substr(0, what.size()) != what) return false;
  t.remove_prefix(what.size());
  return true;
}

constexpr std::string_view middleDot = "\xc2\xb7", squared = "\xc2\xb2", cubed = "\xc2\xb3",
                           degreeC =
                               "\xc2\xb0"
                               "C";

void skipSpace(std::string_view& t) {
  while (!t.empty() && (t.front() == ' ' || t.front() == '\t')) t.remove_prefix(1);
}

std::string_view takeName(std::string_view& t) {
  std::size_t n = 0;
  const auto ends = [&](std::string_view rest) {
    return std::string_view(" \t*/^()").find(rest.front()) != rest.npos || rest.substr(0, 2) == middleDot ||
           rest.substr(0, 2) == squared || rest.substr(0, 2) == cubed;
  };
  while (n < t.size() && !ends(t.substr(n))) n++;
  const std::string_view name = t.substr(0, n);
  t.remove_prefix(n);
  return name;
}

struct UnitParser {
  std::string_view t;
  Factor total;
  Quantity& q;

  bool fail(std::string what) { return q.error = std::move(what), false; }

  /// Reads the exponent after a unit; 1 if there is none.
  bool power(int& p) {
    p = 1;
    if (take(t, squared)) return p = 2, true;
    if (take(t, cubed)) return p = 3, true;
    if (!take(t, "^")) return true;
    const auto [end, code] = std::from_chars(t.data(), t.data() + t.size(), p);
    if (code != std::errc() || std::abs(p) > 9) return fail("a power must be a whole number from -9 to 9");
    t.remove_prefix(static_cast<std::size_t>(end - t.data()));
    return true;
  }

  bool factor(int direction) {
    const std::string_view name = takeName(t);
    if (name.empty()) return fail("a unit is missing");
    Factor f;
    Dimension d;
    if (name == "degC" || name == degreeC) return fail("degC cannot be combined with other units; use K");
    if (!findUnit(name, f, d)) {
      const bool number = name.front() >= '0' && name.front() <= '9';
      const std::string text = "'" + std::string(name) + "'";
      return fail(
          number
              ? text + " is not a unit; expected one number and one unit (expressions are not allowed here)"
              : "unknown unit " + text);
    }
    int p = 1;
    if (!power(p)) return false;
    const bool up = direction * p > 0;
    for (int k = 0; k < std::abs(p); k++) {
      total.numerator *= up ? f.numerator : f.denominator;
      total.denominator *= up ? f.denominator : f.numerator;
    }
    for (std::size_t k = 0; k < d.size(); k++) q.dimension[k] += direction * p * d[k];
    q.hasUnit = true;
    return true;
  }

  /// Reads factors up to the end or a closing parenthesis.
  bool product(int sign, int depth) {
    for (skipSpace(t); !t.empty() && t.front() != ')'; skipSpace(t)) {
      const bool divide = t.front() == '/';
      if (take(t, "/") || take(t, "*") || take(t, middleDot)) skipSpace(t);
      const int direction = divide ? -sign : sign;
      if (!take(t, "(")) {
        if (!factor(direction)) return false;
        continue;
      }
      if (depth > 4) return fail("parentheses are nested too deeply");
      if (!product(direction, depth + 1)) return false;
      if (!take(t, ")")) return fail("a closing parenthesis is missing");
    }
    return true;
  }
};

struct Kind {
  std::string_view unit, text;
};
constexpr Kind kinds[] = {{"m", "a length such as \"2 mm\""},
                          {"s", "a time such as \"40 ms\""},
                          {"K", "a temperature such as \"56 degC\""},
                          {"rad", "an angle such as \"30 deg\""},
                          {"kg/m^3", "a density such as \"900 kg/m^3\""},
                          {"Pa s", "a viscosity such as \"2 Pa s\""},
                          {"N/m", "a force per length such as \"0.03 N/m\""},
                          {"m/s", "a speed such as \"1 m/s\""},
                          {"m/s^2", "an acceleration such as \"9.81 m/s^2\""},
                          {"rad/s", "an angular velocity such as \"90 deg/s\""},
                          {"Pa", "a pressure such as \"60 kPa\""},
                          {"1/s", "a rate such as \"5 1/s\""},
                          {"kg/s", "a mass flow such as \"0.2 kg/s\""},
                          {"W", "a power such as \"200 W\""},
                          {"W/m^2", "an irradiance such as \"1 kW/m^2\""},
                          {"W/(m K)", "a heat conductivity such as \"0.25 W/(m K)\""},
                          {"J/(kg K)", "a heat capacity such as \"2.1 kJ/(kg K)\""},
                          {"J/kg", "a latent heat such as \"200 kJ/kg\""},
                          {"W/kg", "a heat source such as \"50 W/kg\""},
                          {"W/(m^2 K)", "a heat transfer coefficient such as \"10 W/(m^2 K)\""},
                          {"m^2/s", "a diffusivity such as \"1e-6 m^2/s\""},
                          {"1/K", "an expansion such as \"2e-4 1/K\""},
                          {"kg/(m^2 s)", "a mass flow per area such as \"0.1 kg/(m^2 s)\""},
                          {"kg/(m^3 s)", "a drag coefficient such as \"1e6 kg/(m^3 s)\""},
                          {"K/m", "a temperature gradient such as \"100 K/m\""}};

}  // namespace

Quantity parseQuantity(std::string_view t) {
  Quantity q;
  skipSpace(t);
  while (!t.empty() && std::isspace(static_cast<unsigned char>(t.back()))) t.remove_suffix(1);
  if (t.size() > 1 && t.front() == '+' && t[1] != '-') t.remove_prefix(1);
  const auto [end, code] = std::from_chars(t.data(), t.data() + t.size(), q.value);
  if (code == std::errc::result_out_of_range) return q.error = "the number is too large or too small", q;
  if (code != std::errc()) return q.error = missingNumber, q;
  t.remove_prefix(static_cast<std::size_t>(end - t.data()));
  skipSpace(t);
  if (t == "degC" || t == degreeC) {
    q.value += 273.15;
    q.dimension = {0, 0, 0, 1, 0};
    q.hasUnit = true;
    return q;
  }
  UnitParser p{t, {}, q};
  if (p.product(1, 0) && !p.t.empty()) q.error = "a closing parenthesis has no opening one";
  q.value = q.value * p.total.numerator / p.total.denominator;
  return q;
}

Dimension dimensionOf(std::string_view unit) {
  if (unit.empty() || unit == "1") return {};
  return parseQuantity("1 " + std::string(unit)).dimension;
}

std::string kindOfUnit(std::string_view unit) {
  if (unit.empty() || unit == "1") return "a number";
  for (const Kind& k : kinds)
    if (k.unit == unit) return std::string(k.text);
  return "a quantity in " + std::string(unit);
}

}  // namespace thaw
