// SPDX-License-Identifier: Apache-2.0
// Bodies whose particles form several pieces at the start: thin bodies, oblique to the lattice.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

/// Returns bodies, ascending, with adjacent pieces, and the number of these. Pieces are sets of particles
/// that no chain of links (surface.link_length) connects; adjacent ones are less than two spacings apart.
/// Thus no layer of the lattice is missing between them. Requires: gathered particles without components.
/// Ensures: they still have none. Collective.
std::vector<BodyPieces> findStartPieces(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
