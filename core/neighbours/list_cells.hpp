// Who is where, of rows in whatever order.
#pragma once
#include "core/neighbours/grid.hpp"

namespace thaw {

/// The runs of owned rows whose nextCell is the same: the occupied cells of sorted rows; of others a cell may
/// be there several times, and cells in any order.
template<class Rows> void listCells(const Rows& rows, CellTable& cells);

}  // namespace thaw
