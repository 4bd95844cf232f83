// SPDX-License-Identifier: Apache-2.0
// Bits of surfel ids.
#pragma once
#include <cstdint>

namespace thaw {

inline constexpr std::uint64_t surfelBit = std::uint64_t{1} << 63;  ///< set in the id of every surfel
inline constexpr std::uint64_t birthBit = std::uint64_t{1} << 62;   ///< set in the id of every surfel that
                                                                    ///< was not sampled

}  // namespace thaw
