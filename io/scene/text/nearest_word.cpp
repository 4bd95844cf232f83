// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/nearest_word.hpp"

#include <algorithm>
#include <vector>

namespace thaw {
namespace {

/// Optimal string alignment distance (D64): insertions, deletions, replacements, swaps of
/// neighbours.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t k = 0; k <= b.size(); k++) last[k] = k;
  for (std::size_t i = 1; i <= a.size(); i++) {
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); k++) {
      row[k] = std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + (a[i - 1] != b[k - 1])});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        row[k] = std::min(row[k], before[k - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::string nearestWord(const std::string& word, const std::set<std::string>& words) {
  if (word.size() > 100) return "";
  std::string best;
  // largest distance of a suggestion
  std::size_t least = word.size() < 3 ? 2 : std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& w : words)
    if (const std::size_t d = editDistance(word, w); d < least && d < std::max(word.size(), w.size()))
      least = d, best = w;
  return best;
}

std::string suggestion(const std::string& word, const std::set<std::string>& words) {
  const std::string near = nearestWord(word, words);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

}  // namespace thaw
