// SPDX-License-Identifier: Apache-2.0
// Values of a field for colours.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/frames/frame.hpp"

namespace thaw {

/// Field of the colours. part: a component, or -1 for the length of a vector and the Frobenius norm of a
/// symmetric tensor.
struct FieldChoice {
  std::string name;  ///< empty: none
  int part = -1;
};

/// Returns whether values are labels, such as those of bodies and ranks. Their order has no meaning.
bool isLabel(const std::string& name, Element element);

/// Returns name, unit, components and whether it is a label, for each field that colours can show.
nlohmann::ordered_json describeFields(const FrameInfo& info);

/// Returns the values, one per row. Throws IoError if the field lacks this component.
std::vector<float> valuesOf(const FrameColumn& column, std::size_t rows, const FieldChoice& field);

/// Returns labels below 2^31 as they are; a hash with the highest bit set stands for the others.
std::vector<std::uint32_t> labelsOf(const FrameColumn& column, std::size_t rows);

}  // namespace thaw
