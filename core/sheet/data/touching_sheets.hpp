// SPDX-License-Identifier: Apache-2.0
// Sheets whose meshes may touch.
#pragma once
#include <cstddef>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns whether sheets can touch each other or themselves. For one sheet, returns whether it can touch.
inline bool meshesTouch(const Scene& s) {
  return !s.sheets.empty() && (s.sheets.size() > 1 || s.sheets[0].selfContact);
}
inline bool meshTouches(const Scene& s, std::size_t sheet) {
  return s.sheets.size() > 1 || s.sheets[sheet].selfContact;
}

}  // namespace thaw
