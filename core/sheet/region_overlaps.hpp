// SPDX-License-Identifier: Apache-2.0
// Overlapping regions of a sheet. All factors of the later region apply.
#pragma once
#include "core/geometry/basic/signed_distance.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/sheet/data/sheets.hpp"

namespace thaw {

/// Returns a warning for each pair of regions that share vertices, if the later region resets factors of the
/// earlier one. The result is the same on all ranks.
std::vector<SceneWarning> overlapsOfRegions(const SheetBodies& sheets, const Scene& scene,
                                            const MeshLoader& load);

}  // namespace thaw
