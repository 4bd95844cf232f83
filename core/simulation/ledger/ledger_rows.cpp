// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ledger/ledger_rows.hpp"

#include "core/ledger/body_type_row.hpp"
#include "core/oriented/adaptive_sampling/ledger_row.hpp"
#include "core/simulation/world/body_types.hpp"

namespace thaw {

void addBodyTypeRow(const World& w, std::size_t type, std::size_t i, ExactBalance& b) {
  if (type == orientedType) addOrientedRow(w.oriented.rows, i, w.scene.domain.gravity, b);
  else addBodyTypeRow(w.sheets.rows, i, {}, w.scene.domain.gravity, b);
}

}  // namespace thaw
