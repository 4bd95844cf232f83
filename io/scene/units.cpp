#include "io/scene/units.hpp"

#include <cctype>
#include <charconv>
#include <cmath>

namespace thaw {
namespace {

struct Unit { std::string_view name; double factor; Dimension dimension; bool prefixes; };
constexpr double pi = 3.14159265358979323846;
constexpr Unit units[] = {
    {"m", 1, {1, 0, 0, 0}, true},       {"g", 1e-3, {0, 1, 0, 0}, true},     {"s", 1, {0, 0, 1, 0}, true},       {"K", 1, {0, 0, 0, 1}, true},
    {"N", 1, {1, 1, -2, 0}, true},      {"Pa", 1, {-1, 1, -2, 0}, true},     {"J", 1, {2, 1, -2, 0}, true},      {"W", 1, {2, 1, -3, 0}, true},
    {"Hz", 1, {0, 0, -1, 0}, true},     {"l", 1e-3, {3, 0, 0, 0}, true},     {"L", 1e-3, {3, 0, 0, 0}, true},    {"bar", 1e5, {-1, 1, -2, 0}, true},
    {"P", 0.1, {-1, 1, -1, 0}, true},   {"t", 1000, {0, 1, 0, 0}, false},    {"min", 60, {0, 0, 1, 0}, false},   {"h", 3600, {0, 0, 1, 0}, false},
    {"rad", 1, {0, 0, 0, 0}, false},    {"deg", pi / 180, {0, 0, 0, 0}, false}, {"turn", 2 * pi, {0, 0, 0, 0}, false}, {"rpm", 2 * pi / 60, {0, 0, -1, 0}, false},
    {"%", 0.01, {0, 0, 0, 0}, false},   {"1", 1, {0, 0, 0, 0}, false},       {"in", 0.0254, {1, 0, 0, 0}, false}, {"delta_degC", 1, {0, 0, 0, 1}, false}};
struct Prefix { std::string_view name; double factor; };
constexpr Prefix prefixes[] = {{"da", 10}, {"n", 1e-9}, {"u", 1e-6}, {"\xc2\xb5", 1e-6}, {"m", 1e-3}, {"c", 1e-2}, {"d", 0.1}, {"h", 100}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}};

bool findUnit(std::string_view name, double& factor, Dimension& dimension) {
  for (const Unit& u : units)
    if (u.name == name) return factor = u.factor, dimension = u.dimension, true;
  for (const Prefix& p : prefixes)
    if (name.size() > p.name.size() && name.substr(0, p.name.size()) == p.name)
      for (const Unit& u : units)
        if (u.prefixes && u.name == name.substr(p.name.size())) return factor = p.factor * u.factor, dimension = u.dimension, true;
  return false;
}

void skipSpace(std::string_view& t) {
  while (!t.empty() && (t.front() == ' ' || t.front() == '\t')) t.remove_prefix(1);
}

/// A product of units up to the end or a closing parenthesis.
bool parseProduct(std::string_view& t, int sign, Quantity& q, int depth) {
  bool divide = false;
  for (skipSpace(t); !t.empty() && t.front() != ')'; skipSpace(t)) {
    if (t.front() == '*' || t.front() == '/') {
      divide = t.front() == '/';
      t.remove_prefix(1);
      skipSpace(t);
    }
    const int direction = divide ? -sign : sign;
    divide = false;
    if (!t.empty() && t.front() == '(') {
      if (depth > 4) return q.error = "parentheses are nested too deeply", false;
      t.remove_prefix(1);
      if (!parseProduct(t, direction, q, depth + 1)) return false;
      if (t.empty()) return q.error = "a closing parenthesis is missing", false;
      t.remove_prefix(1);
      continue;
    }
    std::size_t n = 0;
    while (n < t.size() && t[n] != ' ' && t[n] != '*' && t[n] != '/' && t[n] != '^' && t[n] != '(' && t[n] != ')' && t[n] != '\t') n++;
    if (n == 0) return q.error = "a unit is missing", false;
    double factor;
    Dimension dimension;
    if (!findUnit(t.substr(0, n), factor, dimension)) return q.error = "unknown unit '" + std::string(t.substr(0, n)) + "'", false;
    t.remove_prefix(n);
    int power = 1;
    if (!t.empty() && t.front() == '^') {
      t.remove_prefix(1);
      const auto [end, code] = std::from_chars(t.data(), t.data() + t.size(), power);
      if (code != std::errc() || std::abs(power) > 9) return q.error = "a power must be a whole number from -9 to 9", false;
      t.remove_prefix(static_cast<std::size_t>(end - t.data()));
    }
    q.value *= std::pow(factor, direction * power);
    for (std::size_t k = 0; k < 4; k++) q.dimension[k] += direction * power * dimension[k];
    q.hasUnit = true;
  }
  return true;
}

}  // namespace

Quantity parseQuantity(std::string_view t) {
  Quantity q;
  skipSpace(t);
  if (!t.empty() && t.front() == '+') t.remove_prefix(1);
  const auto [end, code] = std::from_chars(t.data(), t.data() + t.size(), q.value);
  if (code != std::errc()) return q.error = "no number at its start", q;
  t.remove_prefix(static_cast<std::size_t>(end - t.data()));
  while (!t.empty() && std::isspace(static_cast<unsigned char>(t.back()))) t.remove_suffix(1);
  skipSpace(t);
  if (t == "degC" || t == "\xc2\xb0" "C") {
    q.value += 273.15;
    q.dimension = {0, 0, 0, 1};
    q.hasUnit = true;
    return q;
  }
  if (parseProduct(t, 1, q, 0) && !t.empty()) q.error = "a closing parenthesis without an opening one";
  return q;
}

Dimension dimensionOf(std::string_view unit) {
  if (unit.empty() || unit == "1") return {};
  return parseQuantity("1 " + std::string(unit)).dimension;
}

}  // namespace thaw
