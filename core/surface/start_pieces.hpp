// SPDX-License-Identifier: Apache-2.0
// Bodies whose particles form several pieces at the start: thin bodies, oblique to the lattice.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

/// Returns bodies, ascending, with unconnected particles less than two spacings apart, and the number of such
/// adjacent pieces. No layer of the lattice is missing between them. Connections are chains of links
/// (surface.link_length). Requires: gathered particles without components, which it leaves so. Collective.
std::vector<BodyPieces> findStartPieces(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
