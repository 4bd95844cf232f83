// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/field_values.hpp"

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

bool isWhole(Element element) { return element != Element::F32 && element != Element::F64; }

}  // namespace

bool isLabel(const std::string& name, Element element) { return name != "neighbours" && isWhole(element); }

nlohmann::ordered_json describeFields(const FrameInfo& info) {
  nlohmann::ordered_json fields = nlohmann::ordered_json::array();
  for (const FrameInfo::Field& f : info.fields) {
    if (f.name == "position" || f.name == "id" || f.name == "color" || f.name == "orientation" ||
        f.shape.element == Element::Other)
      continue;
    fields.push_back({{"name", f.name},
                      {"unit", f.unit},
                      {"components", std::max(f.shape.components, 1)},
                      {"label", isLabel(f.name, f.shape.element)},
                      {"whole", isWhole(f.shape.element)}});
  }
  return fields;
}

std::vector<float> valuesOf(const FrameColumn& column, std::size_t rows, const FieldChoice& field) {
  if (field.part >= column.components)
    throw IoError("field " + field.name, "has " + std::to_string(column.components) + " components");
  std::vector<float> values(rows);
  for (std::size_t i = 0; i < rows; i++) {
    if (field.part >= 0 || column.components == 1) {
      values[i] = static_cast<float>(column.value(i, std::max(field.part, 0)));
      continue;
    }
    double sum = 0;
    for (int c = 0; c < column.components; c++) {
      const double v = column.value(i, c);
      sum += (column.components == 6 && c >= 3 ? 2 : 1) * v * v;  // each shear stands for two
    }
    values[i] = static_cast<float>(std::sqrt(sum));
  }
  return values;
}

std::vector<std::uint32_t> labelsOf(const FrameColumn& column, std::size_t rows) {
  constexpr std::uint64_t most = std::uint64_t{1} << 31;
  const bool wide = column.element == Element::U64 || column.element == Element::I64;
  const auto step = static_cast<std::size_t>(column.components);
  std::vector<std::uint32_t> labels(rows);
  for (std::size_t i = 0; i < rows; i++) {
    std::uint64_t label = 0;  // a double has no room for 64 bits
    if (wide) std::memcpy(&label, column.bytes.data() + i * step * sizeof label, sizeof label);
    else label = static_cast<std::uint64_t>(static_cast<std::int64_t>(column.value(i)));
    labels[i] = static_cast<std::uint32_t>(label < most ? label : mixBits(label) % most + most);
  }
  return labels;
}

}  // namespace thaw
