// A number that another content has not, but by an accident of one in 10^14.
#pragma once
#include <bit>
#include <cstdint>

#include "core/math/vec3.hpp"

namespace thaw {

/// FNV-1a (Fowler, Noll & Vo), by words of 64 bits with their high half folded in.
struct Checksum {
  std::uint64_t value = 0xcbf29ce484222325u;
  void add(std::uint64_t word) {
    value = (value ^ word) * 0x100000001b3u;
    value ^= value >> 32;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }  // 0 and -0 are one number
  void add(const Vec3d& x) {
    for (int a = 0; a < 3; a++) add(x[a]);
  }
  double held() const { return static_cast<double>(value >> 16); }  ///< 48 bits of it: a double holds them
};

}  // namespace thaw
