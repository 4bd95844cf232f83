// The surface in `thaw check`.
#pragma once
#include <string>
#include <vector>

#include "core/surface/update_surface.hpp"
#include "parallel/row_courier.hpp"

namespace thaw {

/// Starts the surface of a world that has just started, and measures.
class SurfaceTrial {
 public:
  /// Without the module it does nothing. Where millions of surfels are expected fewer are made, farther apart. Collective.
  SurfaceTrial(const Communicator& comm, World& world, const MeshLoader& load);
  /// One update, after a few steps. Collective.
  void update();
  /// What the surface takes of a whole run of `steps` steps, all ranks together. Zero without the module.
  struct Forecast { double surfels = 0, bytes = 0, updates = 0, frames = 0, seconds = 0; };
  /// Collective.
  Forecast forecast(double steps) const;
  const std::vector<std::uint64_t>& lumps() const { return tools_.lumps; }
  /// What `thaw check` prints, for this many ranks. Collective.
  std::vector<std::string> lines(const Forecast& forecast, int ranks) const;

 private:
  const Communicator& comm_;
  World& world_;
  double expected_ = 0, spacing_ = 0;  // m, that the scene wants
  double perMeasured_ = 1;             // surfels that are expected, for each one that is measured
  SurfaceRanks halos_;
  SurfaceTools tools_;
  double bytes_ = 0, start_ = 0, each_ = 0;

  const CellGrid& gridOfTrial(const MeshLoader& load);
};

/// About how many updates of the surface a run has: one at each frame, and between them as the scene says, for moves of particles at half of the largest
/// speed that is expected of the scene.
double expectedUpdates(const World& world, double steps);

}  // namespace thaw
