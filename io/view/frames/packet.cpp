// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/packet.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace thaw {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they are in memory");

namespace {

constexpr std::size_t alignment = 8;  // typed arrays of a browser need aligned offsets

void pad(std::string& text, char with) {
  while (text.size() % alignment != 0) text += with;
}

template<class T>
PacketArray arrayOf(const char* name, const char* type, std::span<const T> v, int components) {
  PacketArray array{name, type, static_cast<std::size_t>(components), v.size(), {}};
  array.rows /= array.components;
  if (!v.empty()) array.bytes.assign(reinterpret_cast<const char*>(v.data()), v.size_bytes());
  return array;
}

}  // namespace

void Packet::add(const char* name, std::span<const float> v, int components) {
  arrays_.push_back(arrayOf(name, "f32", v, components));
}
void Packet::add(const char* name, std::span<const std::uint32_t> v, int components) {
  arrays_.push_back(arrayOf(name, "u32", v, components));
}
void Packet::add(const char* name, std::span<const std::int16_t> v, int components) {
  arrays_.push_back(arrayOf(name, "i16", v, components));
}
void Packet::add(const char* name, std::span<const std::uint8_t> v, int components) {
  arrays_.push_back(arrayOf(name, "u8", v, components));
}

void Packet::addPositions(std::span<const Vec3d> positions) {
  std::vector<float> v;
  v.reserve(3 * positions.size());
  for (const Vec3d& x : positions)
    for (int a = 0; a < 3; a++) v.push_back(static_cast<float>(x[a]));
  add("position", std::span<const float>(v), 3);
}

void Packet::addNormals(std::span<const Vec3f> normals) {
  std::vector<std::int16_t> v;
  v.reserve(4 * normals.size());
  for (const Vec3f& n : normals) {
    for (int a = 0; a < 3; a++) {
      const double c = std::isfinite(n[a]) ? std::clamp(static_cast<double>(n[a]), -1.0, 1.0) : 0;
      v.push_back(static_cast<std::int16_t>(std::lround(32767 * c)));
    }
    v.push_back(0);
  }
  add("normal", std::span<const std::int16_t>(v), 4);
}

void Packet::addTriangles(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::uint32_t> v;
  v.reserve(3 * triangles.size());
  for (const auto& t : triangles) v.insert(v.end(), t.begin(), t.end());
  add("triangles", std::span<const std::uint32_t>(v), 3);
}

std::string Packet::bytes() const {
  nlohmann::ordered_json described = header;
  std::string data;
  for (const PacketArray& a : arrays_) {
    described["arrays"][a.name] = {
        {"type", a.type}, {"components", a.components}, {"rows", a.rows}, {"offset", data.size()}};
    data += a.bytes;
    pad(data, '\0');
  }
  std::string text = "0000" +
                     described.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  pad(text, ' ');
  const auto length = static_cast<std::uint32_t>(text.size() - 4);
  for (std::size_t k = 0; k < 4; k++) text[k] = static_cast<char>(length >> (8 * k) & 255);
  return text + data;
}

}  // namespace thaw
