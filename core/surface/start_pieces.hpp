// SPDX-License-Identifier: Apache-2.0
// Bodies whose particles form several pieces at the start, such as thin bodies oblique to the lattice.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

/// Returns the bodies with adjacent pieces, ascending, and the numbers of these pieces. Pieces are sets of
/// particles without a chain of links (surface.link_length) between them. Adjacent pieces are less than two
/// spacings apart, so no layer of the lattice is missing between them. Requires: gathered particles without
/// components.
/// Ensures: the particles still have no components. Collective.
std::vector<BodyPieces> findStartPieces(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
