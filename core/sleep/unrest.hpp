// What keeps particles awake (core/sleep/sleep.hpp): what to look at where too little sleeps.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace thaw {

struct World;

/// Why a particle is not calm, the first that holds. None: it has not been calm for long enough, or what is
/// around it is not.
enum class Unrest : std::uint8_t { None, NotSolid, Moves, Accelerates, Warms };
inline constexpr std::size_t unrests = 5;

/// Owned particles that are awake, by Unrest, at the end of a step. Only where particles may sleep.
std::array<std::int64_t, unrests> countAwake(const World& world);

}  // namespace thaw
