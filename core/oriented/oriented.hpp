// The fields of oriented particles (ST92; method.md section 3): one line a field.
#pragma once
#include "core/kinds/kind_rows.hpp"
#include "core/math/quat.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

struct Oriented : KindRows {
  Oriented() : KindRows("oriented") {}
  Column<Quat> orientation{*this, "orientation", "1", Keep::State, "unit quaternion; the normal is where it turns e_z"};
  Column<Vec3d> spin{*this, "spin", "rad/s", Keep::State, "angular velocity"};
  Column<double> inertia{*this, "inertia", "kg m^2", Keep::State, "of its rotation, about any axis"};
};

/// All of the oriented bodies on one rank.
struct OrientedBodies {
  Oriented rows;
  CellTable cells;
};

}  // namespace thaw
