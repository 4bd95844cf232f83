// SPDX-License-Identifier: Apache-2.0
// Thinning of points from which the surface can be rebuilt by interpolation (ST92).
#pragma once
#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {

/// Returns a fraction of the points, fixed: most spread evenly, the others where the interpolant of the kept
/// ones is farthest from the points (greedy centres: C01 section 4), in a few rounds.
SampledPoints thinPoints(const SampledPoints& points, double share, std::uint64_t seed);

}  // namespace thaw
