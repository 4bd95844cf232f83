// Buffers of displacement and iterations, reused from update to update. Nothing of them is part of the state.
#pragma once
#include <cstdint>
#include <vector>

#include "core/particles/column.hpp"
#include "core/surface/bins.hpp"
#include "core/surface/gap_ceilings.hpp"
#include "core/surface/group_lists.hpp"
#include "core/surface/level_table.hpp"
#include "core/surface/surface_kernels.hpp"

namespace thaw {

/// How far (m) volume keeping holds the liquid surface of a component off its level.
struct RaisedComponent {
  std::uint64_t component;
  double by;
};

/// Processor time spent (s), for benchmarks; no result depends on them.
struct RelaxTimes {
  double ready = 0, place = 0, search = 0, surfelSums = 0, particleSums = 0, finish = 0, exchange = 0;
  std::int64_t surfels = 0, searches = 0;
};

struct RelaxTools {
  bool particlesReady = false;  ///< readyParticles was called for the particles as they are; on all ranks or
                                ///< none
  LevelTable level;
  const SurfaceKernels* kernels = surfaceKernels();
  std::vector<std::uint64_t> only;      ///< components, ascending, that iterations move; none: all
  std::vector<RaisedComponent> raised;  ///< ascending by component
  Bins surfelBins, particleBins, gapBins;
  GroupLists lists;
  AlignedVector<double> carried;  ///< carryRecord of each particle
  GapCeilings ceilings;
  AlignedVector<float> place, normal, particle, particleColour, overSurfels, overParticles;
  std::vector<std::uint8_t> free, core;  ///< of owned surfels: listed; and with a surfel that moves in reach
  std::vector<std::uint32_t> groups;
  std::vector<Vec3d> found;  ///< where owned surfels were at the search
  RelaxTimes times;
};

/// Switches a column off: it holds no memory that counts, and is not in checkpoints.
inline void deactivate(AnyColumn& c) {
  c.active = false;
  c.bytes.clear();
}

}  // namespace thaw
