// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <set>
#include <string>

namespace thaw {

/// Returns the word of the list nearest to `word` (edits and swaps of neighbouring letters), or "" if none is
/// near.
std::string nearestWord(const std::string& word, const std::set<std::string>& words);

/// Returns "; did you mean 'x'?", or "" if no word is near.
std::string suggestion(const std::string& word, const std::set<std::string>& words);

}  // namespace thaw
