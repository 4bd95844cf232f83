// SPDX-License-Identifier: Apache-2.0
// Part of a table's fields.
#pragma once
#include "core/fields/column.hpp"

namespace thaw {

/// Base of the groups of fields that make up a table. Their columns register themselves in the table.
struct FieldGroup {
  explicit FieldGroup(Table* t) : table(*t) {}
  Table& table;
};

}  // namespace thaw
