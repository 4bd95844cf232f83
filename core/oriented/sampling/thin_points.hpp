// SPDX-License-Identifier: Apache-2.0
// Selects points from which interpolation can rebuild the surface (ST92).
#pragma once
#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {

/// Returns a fraction of the points, all marked as fixed. Most are spread evenly. The other points are where
/// the interpolant of the kept points is farthest from the original points. They are found in a few rounds
/// (greedy centres: C01 section 4). share: fraction.
SampledPoints thinPoints(const SampledPoints& points, double share, std::uint64_t seed);

}  // namespace thaw
