// SPDX-License-Identifier: Apache-2.0
// Ranges of keys in messages and documents.
#pragma once
#include <string>

#include "core/scene/key_table.hpp"

namespace thaw {

bool holds(const Range& range, double value);
std::string rangeText(const Range& range);         ///< "> 0", "0 ... 1", "any number"
std::string rangeRequirement(const Range& range);  ///< "> 0", "between 0 and 1", "any number"
std::string rangeWords(const Range& range);        ///< ` or "never"`: the words allowed beside numbers, or ""

}  // namespace thaw
