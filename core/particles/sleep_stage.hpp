// SPDX-License-Identifier: Apache-2.0
// Stages of sleep (core/sleep/sleep.hpp).
#pragma once
#include <cstdint>

namespace thaw {

/// Values of Continuum::sleep.
inline constexpr std::uint8_t awake = 0, sleepFixed = 1, sleepSettled = 2, sleeping = 3;

}  // namespace thaw
