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
};  ///< m; unit; rank: position in the random order

/// Adds samples in the order of their ranks. A sample is skipped if any point closer than `apart` (m) has a
/// normal on the same side. Thin bodies have two sides, so points on opposite sides are independent.
void addPoissonDiscs(std::vector<SurfaceSample>& samples, double apart, SampledPoints& points);

}  // namespace thaw
