// The further kinds of body as one list: whoever stores, sends, counts or writes rows walks it and knows no
// kind by name.
#pragma once
#include <array>
#include <cstddef>

#include "core/world.hpp"

namespace thaw {

inline constexpr std::size_t orientedKind = 0, sheetKind = 1, kindCount = 2;
/// of groups in files, frames and messages
inline constexpr std::array<const char*, kindCount> kindNames{"oriented", "sheet"};

/// Calls use(number, rows, cells) for each kind that the scene has. World may be const: so are then rows and
/// cells.
template<class W, class Use> void eachKind(W& w, Use&& use) {
  if (w.oriented.rows.id.active) use(orientedKind, w.oriented.rows, w.oriented.cells);
  if (w.sheets.rows.id.active) use(sheetKind, w.sheets.rows, w.sheets.cells);
}

}  // namespace thaw
