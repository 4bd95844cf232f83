// SPDX-License-Identifier: Apache-2.0
// Removes isolated colours of single surfels.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"

namespace thaw {

struct SurfaceTools;

/// Replaces isolated colours. Where liquids of two colours mix, single surfels move between surfels of the
/// other colour. If the colour of a liquid surfel is rare among its neighbours on its side of the component,
/// it gets their mean colour. Borders between colours and spots of several surfels remain. Solids keep their
/// colours. Does nothing in scenes of one colour. Places the surfels. Collective.
void clearIsolatedColours(const Scene& scene, Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
