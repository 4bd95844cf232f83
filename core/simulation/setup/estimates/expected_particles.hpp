// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"

namespace thaw {

inline constexpr double leastParticleBytes = 400;  ///< bytes per particle: columns and neighbour list

/// Estimates the number of particles of bodies of these shapes at a spacing (m) without sampling them. The
/// estimate follows from the inside fraction of a coarse lattice over the bounding box, or from the box alone
/// if that is small.
double expectedParticles(const std::vector<std::shared_ptr<const SignedDistance>>& shapes, double spacing);

/// Estimates the area (m^2) of these shapes from the number and angle of crossings of lines along the axes.
/// Details finer than a 32nd of a shape's size are missed. Exact for boxes along the axes, else accurate to a
/// few per cent.
double expectedArea(const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

}  // namespace thaw
