// What the tables of all further kinds of body share: one line a field. Sorting, migration, ghosts,
// checkpoints, good states and the ledger work on these and on the columns that a kind adds, so that none of
// them knows the kinds.
#pragma once
#include "core/particles/column.hpp"

namespace thaw {

struct KindRows : Table {
  using Table::Table;
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State,
      "body << 40 | number of the sample in it; of births a hash with the top bit set"};
  Column<Vec3d> position{*this, "position", "m", Keep::State, "centre"};
  Column<Vec3d> velocity{*this, "velocity", "m/s", Keep::State, "of the centre"};
  Column<double> mass{*this, "mass", "kg", Keep::State, "constant"};
  Column<std::uint16_t> body{*this, "body", "1", Keep::State, "index into the scene's bodies of this kind"};
  Column<double> energy{*this, "energy", "J", Keep::State,
      "potential energy of its internal forces and contacts, its own share of pairs"};
  Column<double> dissipated{*this, "dissipated", "J", Keep::State, "mechanical energy lost here so far"};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local, "key of the cell at the last sort"};
  Column<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local, "key of the cell now"};
  // clang-format on
};

/// Switches the shared columns on.
inline void activateKind(KindRows& r) {
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&r.id, &r.position, &r.velocity, &r.mass, &r.body,
                                                        &r.energy, &r.dissipated, &r.cell, &r.nextCell})
    r.activate(*c);
}

}  // namespace thaw
