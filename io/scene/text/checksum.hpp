// SPDX-License-Identifier: Apache-2.0
// A checksum of numbers and texts. Two contents share one with a probability of about 1e-14.
#pragma once
#include <bit>
#include <cstdint>
#include <string_view>

#include "core/math/vec3.hpp"

namespace thaw {

/// FNV-1a (Fowler, Noll & Vo) over 64-bit words, with their high half folded in.
struct Checksum {
  std::uint64_t value = 0xcbf29ce484222325u;
  Checksum& add(std::uint64_t word) {
    value = (value ^ word) * 0x100000001b3u;
    value ^= value >> 32;
    return *this;
  }
  Checksum& add(double number) { return add(std::bit_cast<std::uint64_t>(number + 0.0)); }  // 0 equals -0
  Checksum& add(const Vec3d& x) { return add(x.x).add(x.y).add(x.z); }
  Checksum& add(std::string_view text) {
    for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
    return *this;
  }
  double asDouble() const {
    return static_cast<double>(value >> 16);
  }  ///< its upper 48 bits, exact in a double
};

}  // namespace thaw
