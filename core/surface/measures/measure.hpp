// SPDX-License-Identifier: Apache-2.0
// Measures of components: counts, mass, volume, area.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface.hpp"

namespace thaw {

/// Measures Surface::components, ascending by label, the same on all ranks. Exact sums are independent of the
/// distribution over ranks. Requires Surfels::area and components labelled 1 + the id of one of their
/// particles. Volumes are those of enclosed_volume.hpp. A component across periodic sides is treated as one
/// piece (periodic_unwrap.hpp). The domain is cut in the component's widest gap, and the centroid is wrapped
/// into the domain. An axis without a gap is not used for the volume. If no axis has a gap, the volume is
/// meaningless. Along an axis without a gap, the centroid is the mean of the particles' coordinates in the
/// domain. Without surfels, volume and area are 0. Only components on several ranks exchange whole exact
/// sums. Collective.
void measureComponents(Surface& surface, Reducer& all);

/// Returns the component of a label, or null.
const SurfaceComponent* findComponent(const Surface& surface, std::uint64_t label);

}  // namespace thaw
