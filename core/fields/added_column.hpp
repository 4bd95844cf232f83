// SPDX-License-Identifier: Apache-2.0
// A field of particles that an extension declares (core/terms/extensions.hpp). It is part of the state and
// consists of doubles.
#pragma once
#include "core/fields/column.hpp"

namespace thaw {

struct AddedColumn : AnyColumn {
  double start;  ///< value of all components in particles of bodies and emitters
  bool ghosts;   ///< true: ghosts have the field, for forces between particles

  /// Adds an inactive column to a table. The texts must outlive the column.
  AddedColumn(Table& table, const char* name, const char* unit, const char* about, int components,
              double start, bool ghosts)
      : AnyColumn(table, name, unit, Keep::State, about, Scalar::F64, components,
                  ghosts ? Rows::All : Rows::Owned),
        start(start),
        ghosts(ghosts) {}
  AddedColumn(Table& table, const AddedColumn& like)
      : AddedColumn(table, like.name, like.unit, like.about, like.components, like.start, like.ghosts) {}

  double* data() { return reinterpret_cast<double*>(bytes.data()); }
  const double* data() const { return reinterpret_cast<const double*>(bytes.data()); }
  /// Returns the components of a row.
  double* row(std::size_t i) { return data() + i * static_cast<std::size_t>(components); }
  const double* row(std::size_t i) const { return data() + i * static_cast<std::size_t>(components); }
};

}  // namespace thaw
