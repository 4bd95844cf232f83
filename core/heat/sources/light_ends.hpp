// SPDX-License-Identifier: Apache-2.0
// Obstacles that block light.
#pragma once
#include "core/heat/sources/light_view.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Obstacles that stop rays. Bounded obstacles also count outside of the domain. Sides of the domain let
/// light pass.
struct LightStops {
  const Walls& walls;
  Bounds domain;
  double spacing;  ///< m
};

/// Returns the distance (m) along a ray of the first present obstacle, or infinity. The search begins at the
/// ray's start. For parallel rays, it begins in front of all obstacles.
double endOf(const LightRay& ray, bool parallel, const LightStops& stops);

}  // namespace thaw
