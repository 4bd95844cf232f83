// Values of a scene file as messages repeat them.
#pragma once
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace thaw {

/// A text in quotes, on one line, and not too much of it.
std::string quoted(const std::string& text);

/// What stands where something else was expected: the value, or what kind of thing it is.
std::string shown(const toml::node& node);

/// "a", "b", "c" with their quotes.
std::string listOf(const std::vector<std::string>& words);

}  // namespace thaw
