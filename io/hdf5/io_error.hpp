// What every failure of reading or writing a file is thrown as. The program ends with exit code 3.
#pragma once
#include <stdexcept>
#include <string>

namespace thaw {

inline constexpr int exitInputOutput = 3;

/// "path: what failed, and why".
class IoError : public std::runtime_error {
 public:
  IoError(const std::string& path, const std::string& problem)
      : std::runtime_error(path + ": " + problem), path_(path) {}
  /// An error that another rank met: `message` is that of its IoError.
  explicit IoError(const std::string& message) : std::runtime_error(message) {}
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace thaw
