// Brings surfels and particle copies to the ranks that own their cells, in (cell, id) order.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/neighbours/sort.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Wraps positions at periodic sides, migrates and sorts; ghosts are dropped. Rows are surfels or particle
/// copies. Collective.
template<class Rows>
void placeRows(const CellGrid& grid, CellHalo& halo, Rows& rows, CellTable& cells, SortBuffers& buffers);

/// Copies of the cells around this rank's: afterwards `cells` holds ghost cells, too. Collective.
void addGhosts(CellHalo& halo, Table& rows, CellTable& cells, std::span<AnyColumn* const> columns);
/// Takes ghosts and their cells away again: before ghosts are added anew, `cells` must list the owned ones
/// alone. Not collective.
void dropGhosts(Table& rows, CellTable& cells);
/// Sends columns of the same ghosts again. Collective.
void refreshGhosts(CellHalo& halo, Table& rows, std::span<AnyColumn* const> columns);

}  // namespace thaw
