// SPDX-License-Identifier: Apache-2.0
// Cells of rows that may be in any order.
#pragma once
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Lists the runs of owned rows with equal nextCell. If rows are sorted, these are the occupied cells.
/// Otherwise a cell may appear several times, and cells are in any order.
template<class Rows> void listCells(const Rows& rows, CellTable& cells);

}  // namespace thaw
