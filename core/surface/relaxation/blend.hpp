// SPDX-License-Identifier: Apache-2.0
// Keeps the detail of solids and smooths liquids (K05 4.5).
#pragma once
#include "core/surface/data/surfels.hpp"

namespace thaw {

/// Blends carried and relaxed positions and normals after the iterations of an update. K05 uses x = (1 - b)
/// x_carried + b x_relaxed with the liquid fraction b. This removes the fraction b of every detail in every
/// update. Here, the remaining detail is 1 - b for the largest b since the surfel was solid, and less under
/// strain. It does not depend on the number of updates. Only height added by motion relaxes by the fraction b
/// in each update. The first update in which a surfel is molten uses the paper's formula. `detail` is the
/// remaining fraction. Frozen surfels (b = 0) keep their shape. Births before the iterations are treated like
/// their neighbours, except on crack faces (Surfels::relaxesOnce): these keep their relaxed positions. Does
/// nothing without a liquid fraction. Requires: columns `carried` and `carriedNormal` of displaceSurfels,
/// which are switched off. Not collective; surfels have no valid cells afterwards.
void blendSurfels(Surfels& surfels);

}  // namespace thaw
