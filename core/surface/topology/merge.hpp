// SPDX-License-Identifier: Apache-2.0
// Contact of components: components join, or their surfaces are separated (K05 4.4.2).
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/surface/topology/components.hpp"
#include "core/surface/work/topology_tools.hpp"

namespace thaw {

/// Joins components in contact, or separates their surfaces.
///   - Contact: a particle of one component lies inside the surface of the other. For liquids, the distance
///     of particles of one liquid suffices.
///   - The scene's rule decides. MergeRule::Liquid requires that particle or surface is more than half
///     liquid.
///   - All contacts of an update are united at once, and the smallest label remains.
///   - Joined: surfels inside the other surface, or less than half a spacing off it, are deleted on both
///     sides. Resampling then closes the seam.
///   - Separated: surfels inside the other surface move to the middle between the two.
/// Requires: placed surfels and particles with ghosts. Collective.
/// Ensures: surfels have no ghosts, and may have left their cells.
void mergeComponents(const SurfaceView& view, SurfaceHalos halos, ComponentTools& components,
                     MergeTools& tools);

}  // namespace thaw
