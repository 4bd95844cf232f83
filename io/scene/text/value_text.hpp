// SPDX-License-Identifier: Apache-2.0
// Values of a scene file in messages.
#pragma once
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace thaw {

/// Returns a text in quotes, on one line, shortened to 60 characters.
std::string quoted(const std::string& text);

/// Returns an unexpected value, or its type.
std::string shown(const toml::node& node);

/// Returns "a", "b", "c" with their quotes.
std::string listOf(const std::vector<std::string>& words);

}  // namespace thaw
