// SPDX-License-Identifier: Apache-2.0
// Values of a scene file in messages, in its documentation, and in the restart record.
#pragma once
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "core/math/vec3.hpp"

namespace thaw {

/// Returns a text in quotes, on one line, shortened to 60 characters.
std::string quoted(const std::string& text);

/// Returns an unexpected value, or its type.
std::string shown(const toml::node& node);

/// Returns a number that reads back to the same bits, except that -0 becomes 0; "never" in quotes.
std::string numberText(double value);

/// Returns "[0, 0, 1]".
std::string vectorText(const Vec3d& value);

/// Returns "[a, b, c]" of texts of values, "none" without any.
std::string listText(const std::vector<std::string>& values);

/// Returns "a", "b", "c" with their quotes.
std::string listOf(const std::vector<std::string>& words);

}  // namespace thaw
