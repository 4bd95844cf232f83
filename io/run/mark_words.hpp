// What a scene's marks (scene_marks.hpp) mean, in the words of the scene file.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "io/output/checkpoint.hpp"

namespace thaw {

/// Marks are numbers, those of choices, too. Keys are those of marks without the prefix that says whether
/// they may change.
class MarkWords {
 public:
  explicit MarkWords(const CheckpointValues& marks);
  /// The value of a mark: the word of a choice in quotes, true or false, the name of a material or an
  /// oriented body, "never", else the number.
  std::string text(const std::string& key, double value) const;
  /// A mark's key as the scene file has it: the points of a body that is made of `control` are that.
  std::string key(const std::string& mark) const;
  /// What stands behind numbers in a message: " (SI)", or " (place in the list)"; nothing behind words.
  std::string unit(const std::string& key) const;

 private:
  bool isName(const std::string& key) const { return marks_.contains(key) && named(key); }
  static bool named(const std::string& key);
  std::string nameOf(const std::string& group, double place) const;
  const std::vector<std::string>* wordsOf(const std::string& key) const;
  const CheckpointValues& marks_;
  std::map<std::string, std::vector<std::string>> words_;  // by the first and the last word of a key:
                                                           // "surface merge"
};

}  // namespace thaw
