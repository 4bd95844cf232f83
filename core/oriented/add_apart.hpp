// Of many samples of a surface those that lie apart, in a random order.
#pragma once
#include <cstdint>
#include <vector>

#include "core/oriented/made_points.hpp"

namespace thaw {

struct SurfaceSample {
  std::uint64_t rank;
  Vec3d place, normal;
};  ///< rank: its turn; m

/// Adds samples in the order of their ranks, each unless a point that faces the same way (thin bodies have
/// two sides) is nearer than `apart` (m), those of before among them.
void addApart(std::vector<SurfaceSample>& samples, double apart, MadePoints& points);

}  // namespace thaw
