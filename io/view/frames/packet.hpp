// SPDX-License-Identifier: Apache-2.0
// Binary reply with a JSON header, for typed arrays of a browser:
//   header length (32 bits) | header | arrays
// All are little-endian. Header and arrays are padded to a multiple of 8 bytes. The header's "arrays" name
// each one with its type, components, rows, and byte offset behind the header.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace thaw {

class Packet {
 public:
  nlohmann::ordered_json header;
  /// Adds an array of rows with this number of components.
  void add(const char* name, std::span<const float> values, int components);
  void add(const char* name, std::span<const std::uint32_t> values, int components);
  void add(const char* name, std::span<const std::int16_t> values, int components);
  void add(const char* name, std::span<const std::uint8_t> values, int components);
  /// Returns the whole reply.
  std::string bytes() const;

 private:
  struct Block {
    const char* type;
    const void* data;
    std::size_t count, width;  ///< elements, bytes of each
  };
  void addBlock(const char* name, const Block& block, int components);
  std::string data_;
};

}  // namespace thaw
