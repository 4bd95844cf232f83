// SPDX-License-Identifier: Apache-2.0
// Exception of all failures to read or write a file. The program exits with code 3.
#pragma once
#include <stdexcept>
#include <string>

namespace thaw {

inline constexpr int exitInputOutput = 3;

/// Message "path: problem and reason".
class IoError : public std::runtime_error {
 public:
  IoError(const std::string& path, const std::string& problem)
      : std::runtime_error(path + ": " + problem), path_(path) {}
  /// An error of another rank, with the message of its IoError.
  explicit IoError(const std::string& message) : std::runtime_error(message) {}
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace thaw
