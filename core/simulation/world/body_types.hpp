// SPDX-License-Identifier: Apache-2.0
// List of the body types besides the continuum, for code that treats all types alike.
#pragma once
#include <array>
#include <cstddef>

#include "core/simulation/world/world.hpp"

namespace thaw {

inline constexpr std::size_t orientedType = 0, sheetType = 1, bodyTypeCount = 2;
/// names of groups in files, frames and messages
inline constexpr std::array<const char*, bodyTypeCount> bodyTypeNames{"oriented", "sheet"};

/// Calls use(number, rows, cells) for each body type in the scene. If World is const, so are rows and cells.
template<class W, class Use> void forEachBodyType(W& w, Use&& use) {
  if (w.oriented.rows.id.active) use(orientedType, w.oriented.rows, w.oriented.cells);
  if (w.sheets.rows.id.active) use(sheetType, w.sheets.rows, w.sheets.cells);
}

}  // namespace thaw
