// SPDX-License-Identifier: Apache-2.0
// Columns shared by the tables of all body types except the continuum, one per line. Sorting, migration,
// ghosts, checkpoints, snapshots and the ledger work on these columns and on the columns that a type adds.
// Their code thus does not depend on the type.
#pragma once
#include "core/fields/column.hpp"

namespace thaw {

struct BodyTypeRows : Table {
  using Table::Table;
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State,
      "body << 40 | sample number; a hash with the top bit set for births"};
  Column<Vec3d> position{*this, "position", "m", Keep::State, "centre"};
  Column<Vec3d> velocity{*this, "velocity", "m/s", Keep::State, "velocity of the centre"};
  Column<double> mass{*this, "mass", "kg", Keep::State, "constant"};
  Column<std::uint16_t> body{*this, "body", "1", Keep::State, "index into the scene's bodies of this type"};
  Column<double> energy{*this, "energy", "J", Keep::State,
      "potential energy of internal forces and contacts, with its half of pairs"};
  Column<double> dissipated{*this, "dissipated", "J", Keep::State, "accumulated dissipation"};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local, "key of the cell at the last sort"};
  Column<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local, "key of the current cell"};
  // clang-format on
};

/// Activates the shared columns.
inline void activateBodyType(BodyTypeRows& r) {
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&r.id, &r.position, &r.velocity, &r.mass, &r.body,
                                                        &r.energy, &r.dissipated, &r.cell, &r.nextCell})
    r.activate(*c);
}

}  // namespace thaw
