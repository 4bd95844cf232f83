// SPDX-License-Identifier: Apache-2.0
// Work data of lamps and lasers. All of it follows from the state of a run.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/shapes/pose.hpp"
#include "core/heat/sources/light_view.hpp"

namespace thaw {

/// Light of a cell, found when a particle first needs it.
struct CellLight {
  double power = -1;  ///< 1, of the cell for a source with a power of 1; negative: not found yet
  double end = 0;     ///< m, distance along the light of the first obstacle; infinite: none
};

/// Cells of a view. They are valid until the view or an obstacle moves.
struct CellLights {
  LightView view;
  LightSource source;
  std::vector<CellLight> cell;
};

/// Depths at which rays hit the bodies, the same on all ranks. Values are negated, so one reduction serves
/// both.
struct LightMap {
  std::vector<double> values;         ///< by cell: first negated depths (m) of the nearest particle that each
                                      ///< ray hits. Then negated squares (m^2) of the smallest distance from
                                      ///< the ray to a particle
  std::vector<std::int64_t> weights;  ///< sum of the weights of a cell's particles, by cell
  std::vector<float> covered;         ///< fraction of the cell within the outline; negative: not found yet
  std::size_t cells() const { return weights.size(); }
  bool met(std::size_t c) const { return values[c] > -never; }
  double depth(std::size_t c) const { return -values[c]; }
  double gap2(std::size_t c) const { return -values[cells() + c]; }
};

/// Consecutive rows of a cell, and a sphere (m) that contains them.
struct LightGroup {
  std::uint32_t begin, end;
  Vec3d centre;
  double radius;
};

/// A particle that a view lights.
struct LitRow {
  std::uint32_t view, row;
};

struct LightWork {
  std::vector<LightSource> sources;
  std::vector<LightView> views;
  std::vector<CellLights> lights;  ///< by LightView::cacheIndex
  LightMap map;
  std::vector<LightGroup> groups;
  std::vector<std::uint32_t> order;  ///< groups by their distance along the light
  std::vector<LitRow> lit;
  std::vector<Pose> obstacles;  ///< poses that `lights` belong to
  std::vector<std::uint8_t> present;
};

}  // namespace thaw
