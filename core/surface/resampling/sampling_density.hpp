// SPDX-License-Identifier: Apache-2.0
// Sampling density around a surfel: surplus and gaps.
#pragma once
#include <algorithm>
#include <optional>

#include "core/surface/search/local_surface.hpp"

namespace thaw {

/// Sampling density at a surfel.
struct SamplingDensity {
  bool crowded = false;  ///< a neighbour is too close
  bool thin = false;     ///< there are too few neighbours
  double closest = 0;    ///< least distance over the smaller of the two radii
};

inline bool tooClose(const Surfels& s, std::size_t i, std::size_t j, double closest) {
  const Vec3d d = s.position[j] - s.position[i];
  const double least = closest * std::min(s.radius[i], s.radius[j]);
  return dot(d, d) < least * least;
}

/// Returns the sampling density for the surfels of the patch within `reach` (m), at most three radii.
/// Thresholds are in resample.hpp.
SamplingDensity samplingDensityOf(const Patch& patch, double reach);

/// Returns the middle of the longest uncovered arc on the circle of radius `distance` (m) around the patch's
/// centre, on the surface. No point of the arc has a surfel within `distance`. Requires: a patch of 2.5 times
/// the distance.
std::optional<SurfacePoint> uncoveredPoint(Patch& patch, double distance);

/// Returns the widest angle (rad) without a surfel of the patch within `reach` (m), seen from p in its
/// tangent plane. Below pi, p lies between surfels; above, it lies outside of a border.
double widestGap(const Patch& patch, const SurfacePoint& p, double reach);

}  // namespace thaw
