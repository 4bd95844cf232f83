// SPDX-License-Identifier: Apache-2.0
// Selection of surface samples that keep a minimum distance, in random order (Poisson discs).
#pragma once
#include <cstdint>
#include <vector>

#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {

struct SurfaceSample {
  std::uint64_t rank;
  Vec3d place, normal;
};  ///< rank: place in the random order; lengths in m

/// Adds samples in the order of their ranks. A sample is skipped if a point, old or new, is nearer than
/// `apart` (m) and faces the same way: thin bodies have two sides.
void addPoissonDiscs(std::vector<SurfaceSample>& samples, double apart, SampledPoints& points);

}  // namespace thaw
