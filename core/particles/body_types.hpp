// SPDX-License-Identifier: Apache-2.0
// Numbers and names of the body types except the continuum.
#pragma once
#include <array>
#include <cstddef>

namespace thaw {

inline constexpr std::size_t orientedType = 0, sheetType = 1, bodyTypeCount = 2;
/// Names of the body types in files, frames and messages.
inline constexpr std::array<const char*, bodyTypeCount> bodyTypeNames{"oriented", "sheet"};

}  // namespace thaw
