// SPDX-License-Identifier: Apache-2.0
// Cursor over numbers of a binary file, in either byte order, with bounds checks.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/meshes/read_mesh.hpp"

namespace thaw {

enum class ScalarType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
inline std::size_t sizeOf(ScalarType t) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<int>(t)];
}

class ByteCursor {
 public:
  ByteCursor(std::string_view bytes, std::string file, std::size_t at)
      : bytes_(bytes), file_(std::move(file)), at_(at) {}

  std::size_t left() const { return bytes_.size() - at_; }
  std::size_t offset() const { return at_; }
  void skip(std::uint64_t n) {
    need(n);
    at_ += n;
  }
  void need(std::uint64_t n) const {
    if (n > left())
      fail("the file ends after " + std::to_string(left()) + " of " + std::to_string(n) + " expected bytes");
  }

  /// Reads a number; all these types fit into a double.
  double number(ScalarType type, bool bigEndian) {
    const std::size_t size = sizeOf(type);
    need(size);
    std::uint64_t raw = 0;
    for (std::size_t k = 0; k < size; k++)
      raw = raw << 8 | static_cast<unsigned char>(bytes_[at_ + (bigEndian ? k : size - 1 - k)]);
    at_ += size;
    switch (type) {
      case ScalarType::Int8: return static_cast<std::int8_t>(raw);
      case ScalarType::UInt8: return static_cast<std::uint8_t>(raw);
      case ScalarType::Int16: return static_cast<std::int16_t>(raw);
      case ScalarType::UInt16: return static_cast<std::uint16_t>(raw);
      case ScalarType::Int32: return static_cast<std::int32_t>(raw);
      case ScalarType::UInt32: return static_cast<std::uint32_t>(raw);
      case ScalarType::Float32: return std::bit_cast<float>(static_cast<std::uint32_t>(raw));
      case ScalarType::Float64: return std::bit_cast<double>(raw);
    }
    return 0;
  }
  /// Reads a finite number; what: "a coordinate", for the message.
  double finite(ScalarType type, bool bigEndian, const char* what = "a coordinate") {
    const std::size_t begin = at_;
    const double x = number(type, bigEndian);
    if (!std::isfinite(x))
      at_ = begin, fail("expected " + std::string(what) + ", got a number that is not finite");
    return x;
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw MeshError(file_ + ": byte " + std::to_string(at_) + ": " + message);
  }

 private:
  std::string_view bytes_;
  std::string file_;
  std::size_t at_;
};

}  // namespace thaw
