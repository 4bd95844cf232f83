// SPDX-License-Identifier: Apache-2.0
// Spherical surfaces of drops that are too small for a colour field (docs/validation/stability.md, row 21).
#pragma once
#include <vector>

#include "core/surface/resampling/births.hpp"

namespace thaw {

/// Returns evenly spread surfels on a sphere of this volume (m^3) around `centre`: at least 24, more for a
/// small `spacing` (m). Their radius covers the sphere without holes. Ids follow from component and index,
/// and are the same in each update.
std::vector<SurfelRow> dropSphere(std::uint64_t component, const Vec3d& centre, double volume,
                                  double spacing);

}  // namespace thaw
