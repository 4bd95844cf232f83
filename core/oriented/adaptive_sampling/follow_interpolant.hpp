// SPDX-License-Identifier: Apache-2.0
// Forces that keep particles on the interpolated surface while the surface is rebuilt from given points
// (ST92).
#pragma once
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Projects the free rows of bodies with given points onto the interpolated surface. Stores the projections
/// in Oriented::restPosition and restOrientation. A row without a projection within `lost` spacings is
/// removed. Its mass becomes 0, and the ledger records it as left. Returns the number of removed rows on this
/// rank.
std::int64_t projectRowsOnInterpolant(const OrientedView& view);

/// Returns whether a free row of a body with given points has no projection within `lost` spacings.
bool isOffInterpolant(const Oriented& rows, const OrientedWork& work, std::size_t row);

/// Adds to these rows a spring toward the stored tangent plane, along its normal, and a spring that turns
/// their normal.
void addInterpolantForces(const Oriented& rows, const OrientedWork& work, const Scene& scene,
                          std::vector<Vec3d>& force, std::vector<Vec3d>& torque);

}  // namespace thaw
