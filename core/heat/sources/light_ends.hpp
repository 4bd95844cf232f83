// SPDX-License-Identifier: Apache-2.0
// Obstacles in the way of light.
#pragma once
#include "core/heat/sources/light_view.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Geometry that stops rays: obstacles within the domain, and parts of them outside of it. Sides of the
/// domain let light pass.
struct LightStops {
  const Walls& walls;
  Bounds domain;
  double spacing;  ///< m
};

/// Returns the distance (m) along a ray of the first present obstacle, or infinity. The search begins at the
/// ray's start, or before all obstacles for parallel rays.
double endOf(const LightRay& ray, bool parallel, const LightStops& stops);

}  // namespace thaw
