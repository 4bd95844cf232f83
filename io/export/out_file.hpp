// SPDX-License-Identifier: Apache-2.0
// File written under a temporary name and renamed at the end, so it is either complete or absent.
#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace thaw {

class OutFile {
 public:
  /// Throws IoError with file and cause; so do all other functions.
  explicit OutFile(std::filesystem::path path);
  ~OutFile();  ///< removes the temporary file unless finish() was called
  OutFile(const OutFile&) = delete;
  OutFile& operator=(const OutFile&) = delete;
  void text(std::string_view s) { bytes(s.data(), s.size()); }
  void bytes(const void* data, std::size_t count);
  template<class T> void number(const T& value) { bytes(&value, sizeof(T)); }
  template<class T> void array(const std::vector<T>& values) {
    bytes(values.data(), values.size() * sizeof(T));
  }
  /// Overwrites bytes that are already written.
  void overwrite(std::uint64_t at, const void* data, std::size_t count);
  /// Returns the number of bytes written so far.
  std::uint64_t size() const { return size_; }
  void finish();

 private:
  [[noreturn]] void fail() const;
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::filesystem::path path_, part_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t size_ = 0;
};

}  // namespace thaw
