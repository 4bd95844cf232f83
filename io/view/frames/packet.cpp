// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/packet.hpp"

#include <bit>

namespace thaw {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they are in memory");

namespace {

constexpr std::size_t alignment = 8;  // typed arrays of a browser need aligned offsets

void pad(std::string& text, char with) {
  while (text.size() % alignment != 0) text += with;
}

}  // namespace

void Packet::add(const char* name, std::span<const float> v, int components) {
  addBlock(name, {"f32", v.data(), v.size(), sizeof(float)}, components);
}
void Packet::add(const char* name, std::span<const std::uint32_t> v, int components) {
  addBlock(name, {"u32", v.data(), v.size(), sizeof(std::uint32_t)}, components);
}
void Packet::add(const char* name, std::span<const std::int16_t> v, int components) {
  addBlock(name, {"i16", v.data(), v.size(), sizeof(std::int16_t)}, components);
}
void Packet::add(const char* name, std::span<const std::uint8_t> v, int components) {
  addBlock(name, {"u8", v.data(), v.size(), sizeof(std::uint8_t)}, components);
}

void Packet::addBlock(const char* name, const Block& block, int components) {
  header["arrays"][name] = {{"type", block.type},
                            {"components", components},
                            {"rows", block.count / static_cast<std::size_t>(components)},
                            {"offset", data_.size()}};
  if (block.count > 0) data_.append(static_cast<const char*>(block.data), block.count * block.width);
  pad(data_, '\0');
}

std::string Packet::bytes() const {
  std::string text = "0000" + header.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  pad(text, ' ');
  const auto length = static_cast<std::uint32_t>(text.size() - 4);
  for (std::size_t k = 0; k < 4; k++) text[k] = static_cast<char>(length >> (8 * k) & 255);
  return text + data_;
}

}  // namespace thaw
