// SPDX-License-Identifier: Apache-2.0
// Cells of rows in any order.
#pragma once
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Lists the runs of owned rows with equal nextCell: the occupied cells if rows are sorted. Otherwise a cell
/// may appear several times, and cells are in any order.
template<class Rows> void listCells(const Rows& rows, CellTable& cells);

}  // namespace thaw
