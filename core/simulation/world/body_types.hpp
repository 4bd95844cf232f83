// SPDX-License-Identifier: Apache-2.0
// The body types of a run except the continuum, for code that treats all types alike.
#pragma once
#include "core/particles/body_types.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Calls use(number, rows, cells) for each body type in the scene. If World is const, so are rows and cells.
template<class W, class Use> void forEachBodyType(W& w, Use&& use) {
  if (w.oriented.rows.id.active) use(orientedType, w.oriented.rows, w.oriented.cells);
  if (w.sheets.rows.id.active) use(sheetType, w.sheets.rows, w.sheets.cells);
}

}  // namespace thaw
