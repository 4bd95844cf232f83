// SPDX-License-Identifier: Apache-2.0
// Relaxes sampled points along their surface.
#pragma once
#include "core/geometry/trees/point_tree.hpp"
#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {

/// Spreads free points along the surface by repulsion from free and fixed points within `range` (m). All
/// points move at the same time, so the order does not matter. project(place, normal) projects a position
/// onto the surface and sets the normal.
template<class Project> void relaxPoints(double range, SampledPoints& m, const Project& project) {
  constexpr int passes = 60;
  for (int pass = 0; pass < passes; pass++) {
    const PointTree tree(m.places);
    for (std::size_t i = 0; i < m.places.size(); i++) {
      if (m.flags[i]) continue;
      Vec3d push{};
      for (const std::uint32_t j : tree.within(tree.points()[i], range)) {
        if (j == i || !(dot(m.normals[i], m.normals[j]) > 0)) continue;
        const Vec3d r = tree.points()[i] - tree.points()[j];
        const double far = length(r);
        if (far > 0) push += ((range - far) / far) * r;
      }
      Vec3d n = m.normals[i];
      m.places[i] += 0.25 * (push - dot(push, n) * n);
      for (int k = 0; k < 2; k++) project(m.places[i], n);
    }
    for (std::size_t i = 0; i < m.places.size(); i++)
      if (!m.flags[i]) {
        Vec3d place = m.places[i];
        project(place, m.normals[i]);
      }
  }
}

}  // namespace thaw
