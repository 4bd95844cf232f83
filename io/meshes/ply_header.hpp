// SPDX-License-Identifier: Apache-2.0
// Header of a PLY file.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/meshes/byte_cursor.hpp"
#include "io/meshes/text_cursor.hpp"

namespace thaw {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
  std::string name;
  bool list = false;
  ScalarType countType = ScalarType::UInt8;  ///< for lists
  ScalarType type = ScalarType::Float32;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::int64_t line = 0;  ///< line of the header
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
};

/// Reads from the line 'ply' to 'end_header' and leaves the cursor behind it. Throws MeshError.
PlyHeader readPlyHeader(TextCursor& text);

}  // namespace thaw
