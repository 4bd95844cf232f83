// SPDX-License-Identifier: Apache-2.0
// Colours of surfels that are grown from particles.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/resampling/births.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

struct SurfaceTools;

/// Returns whether surfels may have different colours: a body has a mesh, perhaps with vertex colours, or
/// materials differ in colour.
bool coloursMayDiffer(const Scene& scene);

/// Colours new surfels around particles (SurfelRow::particle). A new surfel gets the mean colour of the
/// component's surfels within two spacings. This avoids single surfels of another colour where liquids mix.
/// Without surfels there, bodies without a mesh keep their material's colour. Bodies with a mesh get the
/// colour of the nearest surfel of the component within a cell's edge of the particle. Of equally near
/// surfels, the one with the smaller id counts. If the component has no surfel there, as for a drop that has
/// just separated, the nearest surfel of any component counts. Requires: bins of the surfels with ghosts.
void inheritColours(const Scene& scene, const Surface& surface, const Bins& bins,
                    std::vector<SurfelRow>& rows);

/// Colours new surfels for placed surfels without ghosts. Does nothing in scenes of one colour. Collective.
void inheritColours(const Scene& scene, Surface& surface, SurfaceHalos halos, SurfaceTools& tools,
                    std::vector<SurfelRow>& rows);

}  // namespace thaw
