// SPDX-License-Identifier: Apache-2.0
// Operations on single rows of a table.
#pragma once
#include <cstring>

#include "core/fields/column.hpp"

namespace thaw {

inline void copyRow(Table& t, std::size_t from, std::size_t to) {
  for (AnyColumn* c : t.columns)
    if (c->active)
      std::memcpy(c->bytes.data() + to * c->elementBytes, c->bytes.data() + from * c->elementBytes,
                  c->elementBytes);
}

inline void clearRow(Table& t, std::size_t row) {
  for (AnyColumn* c : t.columns)
    if (c->active) std::memset(c->bytes.data() + row * c->elementBytes, 0, c->elementBytes);
}

}  // namespace thaw
