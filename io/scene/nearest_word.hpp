#pragma once
#include <set>
#include <string>

namespace thaw {

/// The word of the list that is nearest to `word` (edits and swaps of neighbouring letters), or "" where none
/// is near.
std::string nearestWord(const std::string& word, const std::set<std::string>& words);

/// "; did you mean 'x'?" or "" where no word is near.
std::string suggestion(const std::string& word, const std::set<std::string>& words);

}  // namespace thaw
