// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_fields.hpp"

#include <fmt/format.h>

#include "core/scene/field_values.hpp"
#include "io/scene/text/expression.hpp"
#include "io/scene/text/value_text.hpp"

namespace thaw {
namespace {

/// Reads a quantity into `value`, or an expression into `field`.
struct NumberKey {
  const char *key, *unit;
  Range range;
  const char* about;
};
void readNumberOrField(TableReader& r, const NumberKey& k, double& value, PositionField& field) {
  if (r.recording() && field)
    return static_cast<void>(r.node(k.key, k.unit, "", "", "\"" + field.text + "\""));
  const std::string text = r.textOf(k.key);
  if (!r.reading() || !looksLikeExpression(text))
    return r.orAs(KeyForm::Type::Expression).number(k.key, value, k.unit, k.range, k.about);
  const toml::node* n = r.node(k.key, k.unit, "", k.about);
  Expression e = parseExpression(text);
  if (!e.error.empty())
    return r.refuseValue(
        k.key,
        fmt::format("expected an expression of x, y and z (m, without units; its value is in {}), got {}: {}",
                    k.unit, quoted(text), e.error));
  field = {text, r.path().empty() ? k.key : r.path() + "." + k.key, placeOfNode(*n), std::move(e.value)};
}

void readComponents(TableReader& r, Vec3d& velocity, VelocityField& field) {
  constexpr const char* axes[3] = {"x", "y", "z"};
  const Range slow = between(-fastestStart, fastestStart);
  for (int a = 0; a < 3; a++)
    readNumberOrField(r, {axes[a], "m/s", slow, ""}, velocity[a], field.component[a]);
}

/// Returns three components as text of a list.
std::string componentsText(const Vec3d& velocity, const VelocityField& field) {
  std::vector<std::string> texts;
  for (int a = 0; a < 3; a++)
    texts.push_back(field.component[a] ? "\"" + field.component[a].text + "\"" : numberText(velocity[a]));
  return listText(texts);
}

}  // namespace

void readVelocity(TableReader& r, Vec3d& velocity, VelocityField& field, const char* about) {
  if (r.recording())
    return static_cast<void>(r.node("velocity", "m/s", "", "", componentsText(velocity, field)));
  if (!r.isTable("velocity")) {
    r.orAs(KeyForm::Type::Expression).vector("velocity", velocity, "m/s", about);
    for (int a = 0; a < 3; a++)
      if (!isStartSpeed(velocity[a])) return r.refuseValue("velocity", expectedSpeeds);
    return;
  }
  r.table("velocity", about, [&](TableReader& t) { readComponents(t, velocity, field); });
}

void readVelocityField(TableReader& r, VelocityField& field, const char* about) {
  if (!r.reading()) {
    const bool given = field.component[0] || field.component[1] || field.component[2];
    r.node("velocity", "m/s", "table of expressions x, y, z", about,
           given ? componentsText({}, field) : "none");
    return;
  }
  r.table("velocity", about, [&](TableReader& t) {
    Vec3d constant{};
    readComponents(t, constant, field);
    for (int a = 0; a < 3; a++)
      if (constant[a] != 0)
        field.component[a] = {fmt::format("{}", constant[a]), t.path() + "." + "xyz"[a], t.place(),
                              [v = constant[a]](const Vec3d&) { return v; }};
  });
}

void readVelocityGradient(TableReader& r, VelocityField& field, const char* about) {
  constexpr const char* key = "velocity_gradient";
  const Vec3d* slope = field.gradient.row;
  const toml::node* n = r.node(
      key, "1/s", "three lists of three numbers", about,
      field.linear ? listText({vectorText(slope[0]), vectorText(slope[1]), vectorText(slope[2])}) : "none");
  if (!n) return;
  const toml::array* rows = n->as_array();
  const auto refuse = [&](const std::string& got) {
    r.refuseValue(
        key,
        "expected three lists of three quantities, [[dvx/dx, dvx/dy, dvx/dz], [dvy/dx, ...], [dvz/dx, "
        "...]], got " +
            got);
  };
  if (!rows || rows->size() != 3) return refuse(rows ? fmt::format("a list of {}", rows->size()) : shown(*n));
  for (std::size_t i = 0; i < 3; i++) {
    const toml::array* row = rows->get(i)->as_array();
    if (!row || row->size() != 3)
      return refuse(row ? fmt::format("a list of {} in place {}", row->size(), i + 1)
                        : fmt::format("{} in place {}", shown(*rows->get(i)), i + 1));
    for (std::size_t j = 0; j < 3; j++)
      r.quantity(*row->get(j), key, "1/s", anyNumber(), field.gradient.row[i][static_cast<int>(j)]);
  }
  field.linear = true;
  field.gradientWhere = placeOfNode(*n);
}

void readTemperature(TableReader& r, double& temperature, PositionField& field, const char* about) {
  readNumberOrField(r, {"temperature", "K", positive(), about}, temperature, field);
}

}  // namespace thaw
