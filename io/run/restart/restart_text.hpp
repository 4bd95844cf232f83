// SPDX-License-Identifier: Apache-2.0
// Text of the restart record (restart_record.hpp) in the terms of the scene file.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "io/checkpoint/checkpoint.hpp"

namespace thaw {

/// Translates entries of the restart record, which are all numbers. Keys come without the prefix that says
/// whether they may change.
class RestartRecordText {
 public:
  explicit RestartRecordText(const CheckpointValues& record);
  /// Returns a value as text: the word of a choice in quotes, true or false, the name of a material or an
  /// oriented body, "never", or the number.
  std::string text(const std::string& key, double value) const;
  /// Returns a key as in the scene file. Points of a body have the key `control` if it is made of them.
  std::string key(const std::string& mark) const;
  /// Returns the text behind numbers in a message: " (SI)", or " (place in the list)". Returns "" behind
  /// words.
  std::string unit(const std::string& key) const;

 private:
  bool isName(const std::string& key) const { return record_.contains(key) && named(key); }
  static bool named(const std::string& key);
  std::string nameOf(const std::string& group, double place) const;
  const std::vector<std::string>* wordsOf(const std::string& key) const;
  const CheckpointValues& record_;
  std::map<std::string, std::vector<std::string>> words_;  // keyed by the first and the last word of a key,
                                                           // as "surface merge"
};

}  // namespace thaw
