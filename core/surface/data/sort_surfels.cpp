// SPDX-License-Identifier: Apache-2.0
// The sort of core/neighbours/sort.hpp for the tables of a surface.
#include "core/neighbours/sort_rows.hpp"
#include "core/surface/data/surfels.hpp"

namespace thaw {

template void computeCellKeys(const CellGrid&, Surfels&, std::size_t, std::size_t);
template void computeCellKeys(const CellGrid&, SurfaceParticles&, std::size_t, std::size_t);
template void sortByCell(Surfels&, const Migration&, SortBuffers&, CellTable&, std::span<AnyColumn* const>);
template void sortByCell(SurfaceParticles&, const Migration&, SortBuffers&, CellTable&,
                         std::span<AnyColumn* const>);

}  // namespace thaw
