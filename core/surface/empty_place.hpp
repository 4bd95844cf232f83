// Where the neighbourhood of a surfel is too full, and where it is empty.
#pragma once
#include <algorithm>
#include <optional>

#include "core/surface/local_surface.hpp"

namespace thaw {

/// How a surfel stands among its neighbours.
struct Crowding {
  bool crowded = false;  ///< one of them is too close
  bool thin = false;     ///< there are too few
  double closest = 0;    ///< what is too close, over the smaller radius of the two
};

inline bool tooClose(const Surfels& s, std::size_t i, std::size_t j, double closest) {
  const Vec3d d = s.position[j] - s.position[i];
  const double least = closest * std::min(s.radius[i], s.radius[j]);
  return dot(d, d) < least * least;
}

/// patch: surfels of its side within `reach` (m), at most three radii (resample.hpp says what counts).
Crowding crowdingOf(const Patch& patch, double reach);

/// The middle of the longest arc of the circle of radius `distance` (m) around the patch's centre, on the
/// surface, of which no point has a surfel within `distance`. The patch has to reach to 2.5 times the
/// distance.
std::optional<SurfacePoint> emptyPlace(Patch& patch, double distance);

/// The widest angle (rad) without a surfel of the patch within `reach` (m), seen from p along its tangent
/// plane: below pi, p lies between surfels; above, it lies before a border.
double widestGap(const Patch& patch, const SurfacePoint& p, double reach);

}  // namespace thaw
