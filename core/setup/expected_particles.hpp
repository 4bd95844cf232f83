#pragma once
#include <memory>
#include <vector>

#include "core/geometry/signed_distance.hpp"

namespace thaw {

inline constexpr double leastParticleBytes = 400;  ///< of a particle: columns and neighbour list

/// About how many particles the bodies of these shapes take at this spacing (m), found without sampling them:
/// by the share of a coarse lattice over the bounding box that lies inside, or by the bounding box alone
/// where that is not much.
double expectedParticles(const std::vector<std::shared_ptr<const SignedDistance>>& shapes, double spacing);

/// About the area (m^2) of these shapes, by how often lines along the axes cross them, and at what angle;
/// what is finer than a 32nd of a shape's size is not seen. Exact for boxes along the axes, else to some per
/// cent.
double expectedArea(const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

}  // namespace thaw
