// The fields of the vertices of sheets (DS; method.md section 4): one line a field.
#pragma once
#include "core/kinds/kind_rows.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

struct Sheets : KindRows {
  Sheets() : KindRows("sheet") {}
  Column<Vec3d> rest{*this, "rest", "m", Keep::State, "q0: where the vertex is without forces"};
};

/// All of the sheets on one rank.
struct SheetBodies {
  Sheets rows;
  CellTable cells;
};

}  // namespace thaw
