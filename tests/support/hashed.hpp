// SPDX-License-Identifier: Apache-2.0
// Random numbers for tests: a function of the index, the same on every rank and in every run.
#pragma once
#include <cstdint>

namespace thaw::test {

/// Uniform in [0, 1).
inline double hashed(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdull;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ull;
  x ^= x >> 33;
  return static_cast<double>(x >> 11) * 0x1p-53;
}

}  // namespace thaw::test
