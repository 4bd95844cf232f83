// SPDX-License-Identifier: Apache-2.0
// Buffers of displacement and iterations, reused between updates. They are not part of the state.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/fields/column.hpp"
#include "core/surface/data/level_table.hpp"
#include "core/surface/kernels/surface_kernels.hpp"
#include "core/surface/search/bins.hpp"
#include "core/surface/search/gap_cutoffs.hpp"
#include "core/surface/search/group_lists.hpp"

namespace thaw {

/// Offset (m) of a component's liquid surface from its level, due to volume enforcement.
struct ComponentIsoOffset {
  std::uint64_t component;
  double by;
};

/// Processor time (s) for benchmarks. No result depends on it.
struct RelaxTimes {
  double ready = 0, place = 0, search = 0, surfelSums = 0, particleSums = 0, finish = 0, exchange = 0;
  std::int64_t surfels = 0, searches = 0;
};

struct RelaxTools {
  /// prepareParticles was called for the current particles; the same on all ranks
  bool particlesPrepared = false;
  LevelTable level;
  const SurfaceKernels* kernels = surfaceKernels();
  std::vector<std::uint64_t> only;            ///< components, ascending, that iterations move; empty: all
  std::vector<ComponentIsoOffset> isoOffset;  ///< ascending by component
  Bins surfelBins, particleBins, gapBins;
  GroupLists lists;
  AlignedVector<double> carried;  ///< packed data of each particle, carryRecord doubles
  GapCutoffs gapCutoffs;
  AlignedVector<float> place, normal, particle, particleColour, overSurfels, overParticles;
  /// flags of owned surfels: listed, and with a moving surfel within reach
  std::vector<std::uint8_t> free, core;
  std::vector<std::uint32_t> groups;
  std::vector<Vec3d> found;  ///< m, positions of owned surfels at the last search
  RelaxTimes times;
};

/// Sums of one lane: channel c at [8 c + lane].
struct SurfelSums {
  const float *surfels, *particles;
  int lane;
  double surfel(int channel) const { return static_cast<double>(surfels[8 * channel + lane]); }
  double particle(int channel) const { return static_cast<double>(particles[8 * channel + lane]); }
};

/// Returns the offset (m) of a component's surface from its level; 0 if the component is not listed.
inline double isoOffsetOf(const std::vector<ComponentIsoOffset>& isoOffset, std::uint64_t component) {
  const auto at = std::lower_bound(
      isoOffset.begin(), isoOffset.end(), component,
      [](const ComponentIsoOffset& p, std::uint64_t c) { return p.component < c; });
  return at != isoOffset.end() && at->component == component ? at->by : 0;
}

}  // namespace thaw
