// SPDX-License-Identifier: Apache-2.0
// Binary reply with a JSON header, for typed arrays of a browser:
//   header length (32 bits) | header | arrays
// All are little-endian. Header and arrays are padded to a multiple of 8 bytes. The header's "arrays" name
// each one with its type, components, rows, and byte offset behind the header.
#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

/// An array of a packet: rows of `components` elements.
struct PacketArray {
  std::string name, type;  ///< type: "f32", "u32", "i16", "u8"
  std::size_t components = 1, rows = 0;
  std::string bytes;
};

class Packet {
 public:
  nlohmann::ordered_json header;
  /// Adds an array of rows with this number of components.
  void add(const char* name, std::span<const float> values, int components);
  void add(const char* name, std::span<const std::uint32_t> values, int components);
  void add(const char* name, std::span<const std::int16_t> values, int components);
  void add(const char* name, std::span<const std::uint8_t> values, int components);
  /// Adds `position`, three components.
  void addPositions(std::span<const Vec3d> positions);
  /// Adds `normal`: unit vectors in 16 bits each, with a fourth component for the alignment.
  void addNormals(std::span<const Vec3f> normals);
  /// Adds `triangles`.
  void addTriangles(std::span<const std::array<std::uint32_t, 3>> triangles);
  const std::vector<PacketArray>& arrays() const { return arrays_; }
  /// Returns the whole reply.
  std::string bytes() const;

 private:
  std::vector<PacketArray> arrays_;
};

}  // namespace thaw
