// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers: a pure function of seed, purpose, id and step. They are the same on any
// number of ranks, in any order and after a restart.
#pragma once
#include <cstdint>

namespace thaw {

/// Purpose of a random number; numbers of different purposes are independent. The values are part of the
/// results: append only.
enum class Purpose : std::uint64_t {
  Jitter = 1,
  Emission = 2,
  Separate = 3,
  SurfelSample = 11,
  SurfelBirth = 12,
  SurfelDeath = 13,
  OrientedSample = 21,
  OrientedBirth = 22,
  OrientedDeath = 23,
  OrientedKick = 24,
  Test = 1000
};

/// Mixes 64 bits so that every bit of the argument changes about half of the result's (the finaliser of
/// SplitMix64, SLF14).
inline std::uint64_t mixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// 64 random bits of (seed, purpose, id, step).
inline std::uint64_t randomBits(std::uint64_t seed, Purpose purpose, std::uint64_t id,
                                std::uint64_t step = 0) {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15ull;  // 2^64 over the golden ratio; separates arguments
                                                        // that are small numbers
  std::uint64_t h = mixBits(seed + odd);
  h = mixBits(h + odd * (static_cast<std::uint64_t>(purpose) + 1));
  h = mixBits(h + odd * (id + 1));
  return mixBits(h + odd * (step + 1));
}

/// Uniform in [0, 1), a multiple of 2^-53.
inline double randomUniform(std::uint64_t seed, Purpose purpose, std::uint64_t id, std::uint64_t step = 0) {
  return static_cast<double>(randomBits(seed, purpose, id, step) >> 11) * 0x1p-53;
}

}  // namespace thaw
