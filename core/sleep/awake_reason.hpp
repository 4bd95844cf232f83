// SPDX-License-Identifier: Apache-2.0
// Reasons for which particles stay awake (core/sleep/sleep.hpp), for diagnostics.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace thaw {

struct Continuum;
struct Scene;

/// First reason for which a particle is not at rest. None: the particle is at rest, but its rest time is too
/// short or its surroundings are not at rest.
enum class AwakeReason : std::uint8_t { None, NotSolid, Moves, Accelerates, Warms };
inline constexpr std::size_t awakeReasons = 5;

/// Counts owned awake particles by AwakeReason at the end of a step. Requires: Modules::sleep.
std::array<std::int64_t, awakeReasons> countAwake(const Continuum& particles, const Scene& scene);

}  // namespace thaw
