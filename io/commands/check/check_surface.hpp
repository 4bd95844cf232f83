// SPDX-License-Identifier: Apache-2.0
// Trial of the surface for `thaw check`.
#pragma once
#include <string>
#include <vector>

#include "core/simulation/world/world.hpp"
#include "core/surface/update_surface.hpp"
#include "parallel/row_scatter.hpp"

namespace thaw {

/// Starts the surface of a world that has just started, and measures time and memory.
class SurfaceTrial {
 public:
  /// Does nothing without the surface module. Coarsens a surface of more than 1e5 expected surfels.
  /// Collective.
  SurfaceTrial(const Communicator& comm, World& world, const MeshLoader& load);
  /// Times an update after a few steps. If the scene has liquid, times another update with all material
  /// molten and moving. It iterates over the whole surface, including the parts on solids. Afterwards only
  /// the counts of the world are valid. Collective.
  void update();
  /// Cost of the surface over a run of `steps` steps, summed over ranks. surfelsTogether: the liquid stays
  /// together; surfelsMost: all of it breaks up into drops (the same without liquid). Zero without the
  /// module.
  struct Forecast {
    double surfels = 0, surfelsTogether = 0, surfelsMost = 0, bytes = 0, updates = 0, frames = 0, seconds = 0,
           secondsMost = 0;
  };
  /// particles: number at the end, including emitted ones. Collective.
  Forecast forecast(double steps, double particles) const;
  const std::vector<std::uint64_t>& mergedSheets() const { return tools_.mergedSheets; }
  const std::vector<BodyPieces>& pieces() const { return tools_.pieces; }
  /// Returns the lines that `thaw check` prints, for this many ranks. Collective.
  std::vector<std::string> lines(const Forecast& forecast, int ranks) const;

 private:
  const Communicator& comm_;
  World& world_;
  double expected_ = 0, spacing_ = 0;  // expected surfels; spacing of the scene, m
  double perMeasured_ = 1;             // expected surfels per measured surfel
  SurfaceRanks halos_;
  SurfaceTools tools_;
  std::int64_t surfels_ = 0;                               // sum over ranks, after the start
  double bytes_ = 0, start_ = 0, each_ = 0, flowing_ = 0;  // bytes; s of the start, an update at the start,
                                                           // an update of melt

  const CellGrid& gridOfTrial(const MeshLoader& load);
  double timeOfUpdate();
};

/// Returns the expected number of surface updates of a run. There is one at each frame, and others by the
/// settings of the scene. Particles move at half the largest expected speed.
double expectedUpdates(const Scene& scene, const CellGrid& grid, double steps);

}  // namespace thaw
