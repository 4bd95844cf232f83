// SPDX-License-Identifier: Apache-2.0
// A checksum of numbers. Two contents share one with a probability of about 1e-14.
#pragma once
#include <bit>
#include <cstdint>

#include "core/math/vec3.hpp"

namespace thaw {

/// FNV-1a (Fowler, Noll & Vo) over 64-bit words, with their high half folded in.
struct Checksum {
  std::uint64_t value = 0xcbf29ce484222325u;
  void add(std::uint64_t word) {
    value = (value ^ word) * 0x100000001b3u;
    value ^= value >> 32;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }  // 0 and -0 are equal
  void add(const Vec3d& x) {
    for (int a = 0; a < 3; a++) add(x[a]);
  }
  double asDouble() const {
    return static_cast<double>(value >> 16);
  }  ///< its upper 48 bits, exact in a double
};

}  // namespace thaw
