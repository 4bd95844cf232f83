// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of elastic solids: bonds (bond_forming.hpp) and rest (core/sleep/sleep.hpp).
struct SolidFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<std::uint32_t> solidIndex{table, "solid_index", "1", Keep::Local,
      "row in the table of solids; noSolid for liquids"};
  Column<Mat3d> frame{table, "frame", "1", Keep::Transient,
      "deformation gradient F; the identity if the particle has just frozen"};
  Column<std::uint8_t> justFrozen{table, "justFrozen", "1", Keep::State,
      "1: froze in this step; forms its bonds in the next step, also on another rank or after a restart"};
  Column<float> restTime{table, "restTime", "s", Keep::State,
      "time since it last moved, accelerated or warmed; with numerics.rigidify, since it last deformed"};
  Column<std::uint8_t> sleep{table, "sleep", "1", Keep::State,
      "0: awake; 1, 2: sleeping, fixed in place; 3: sleeping, and its sums are skipped"};
  Column<Vec3d> constraintForce{table, "constraintForce", "N", Keep::State,
      "constraint force of a sleeping particle: balances its weight and all forces except those of walls; "
      "with numerics.rigidify, the load on it as its energy became constant, in the body frame"};
  // clang-format on
};

}  // namespace thaw
