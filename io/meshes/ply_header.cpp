// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/ply_header.hpp"

#include <utility>

namespace thaw {
namespace {

ScalarType scalarType(TextCursor& text) {
  static constexpr std::pair<std::string_view, ScalarType> names[] = {
      {"char", ScalarType::Int8},      {"int8", ScalarType::Int8},       {"uchar", ScalarType::UInt8},
      {"uint8", ScalarType::UInt8},    {"short", ScalarType::Int16},     {"int16", ScalarType::Int16},
      {"ushort", ScalarType::UInt16},  {"uint16", ScalarType::UInt16},   {"int", ScalarType::Int32},
      {"int32", ScalarType::Int32},    {"uint", ScalarType::UInt32},     {"uint32", ScalarType::UInt32},
      {"float", ScalarType::Float32},  {"float32", ScalarType::Float32}, {"double", ScalarType::Float64},
      {"float64", ScalarType::Float64}};
  const std::string_view word = text.wordOnLine();
  for (const auto& [name, type] : names)
    if (word == name) return type;
  text.fail("expected a type (char, uchar, short, ushort, int, uint, float, double), got " +
            TextCursor::shown(word));
}

PlyFormat readFormat(TextCursor& text) {
  const std::string_view word = text.wordOnLine();
  if (word == "ascii") return PlyFormat::Ascii;
  if (word == "binary_little_endian") return PlyFormat::LittleEndian;
  if (word == "binary_big_endian") return PlyFormat::BigEndian;
  text.fail("expected the format 'ascii', 'binary_little_endian' or 'binary_big_endian', got " +
            TextCursor::shown(word));
}

PlyElement readElement(TextCursor& text) {
  PlyElement e;
  e.line = text.line();
  e.name = std::string(text.wordOnLine());
  const std::int64_t n = text.integer(text.wordOnLine(), "the number of elements");
  if (e.name.empty() || n < 0) text.fail("expected 'element NAME COUNT' with a count that is not negative");
  e.count = static_cast<std::uint64_t>(n);
  return e;
}

PlyProperty readProperty(TextCursor& text) {
  PlyProperty p;
  TextCursor ahead = text;
  if (ahead.wordOnLine() == "list") {
    text = ahead;
    p.list = true;
    p.countType = scalarType(text);
    if (p.countType == ScalarType::Float32 || p.countType == ScalarType::Float64)
      text.fail("expected an integer type for the length of a list");
  }
  p.type = scalarType(text);
  p.name = std::string(text.wordOnLine());
  if (p.name.empty()) text.fail("expected the name of a property, got the end of the line");
  return p;
}

}  // namespace

PlyHeader readPlyHeader(TextCursor& text) {
  PlyHeader h;
  bool format = false;
  text.restOfLine();  // ply
  while (true) {
    if (text.atEnd()) text.fail("expected 'end_header', got the end of the file");
    const std::string_view word = text.wordOnLine();
    if (word == "end_header") {
      text.restOfLine();
      break;
    }
    if (word == "format") {
      h.format = readFormat(text);
      format = true;
    } else if (word == "element") {
      h.elements.push_back(readElement(text));
    } else if (word == "property") {
      if (h.elements.empty()) text.fail("expected an element before the first property");
      h.elements.back().properties.push_back(readProperty(text));
    } else if (word != "comment" && word != "obj_info" && !word.empty()) {
      text.fail("expected 'format', 'element', 'property', 'comment' or 'end_header', got " +
                TextCursor::shown(word));
    }
    text.restOfLine();
  }
  if (!format) text.fail("the header has no line 'format'");
  return h;
}

}  // namespace thaw
