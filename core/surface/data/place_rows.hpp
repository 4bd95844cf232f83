// SPDX-License-Identifier: Apache-2.0
// Migrates surfels and particle copies to the ranks that own their cells, in (cell, id) order.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/neighbours/sort.hpp"
#include "core/surface/data/surface.hpp"

namespace thaw {

/// Wraps positions at periodic sides, migrates and sorts. Ghosts are dropped. Rows are surfels or particle
/// copies. Collective.
template<class Rows>
void placeRows(const CellGrid& grid, CellHalo& halo, Rows& rows, CellTable& cells, SortBuffers& buffers);

/// Adds ghosts of the surrounding cells. `cells` then lists ghost cells as well. Collective.
void addGhosts(CellHalo& halo, Table& rows, CellTable& cells, std::span<AnyColumn* const> columns);
/// Drops ghosts and their cells. Call it before ghosts are added again, because `cells` must then list only
/// owned cells. Not collective.
void dropGhosts(Table& rows, CellTable& cells);
/// Sends columns of existing ghosts again. Collective.
void refreshGhosts(CellHalo& halo, Table& rows, std::span<AnyColumn* const> columns);

}  // namespace thaw
