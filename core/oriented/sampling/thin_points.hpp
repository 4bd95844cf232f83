// SPDX-License-Identifier: Apache-2.0
// Thinning of points from which the surface can be rebuilt by interpolation (ST92).
#pragma once
#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {

/// Returns a fraction of the points, all marked as fixed. Most are spread evenly. The others are where the
/// interpolant of the kept ones is farthest from the points, found in a few rounds (greedy centres: C01
/// section 4).
SampledPoints thinPoints(const SampledPoints& points, double share, std::uint64_t seed);

}  // namespace thaw
