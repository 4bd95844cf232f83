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
  /// Without the module it does nothing. Where millions of surfels are expected fewer are made, farther
  /// apart. Collective.
  SurfaceTrial(const Communicator& comm, World& world, const MeshLoader& load);
  /// One update, after a few steps; and another one as when all of it is liquid and flows, where something
  /// can be: it is an update of the whole surface through all its iterations, where solids are carried along.
  /// The world is of no more use then than to be counted. Collective.
  void update();
  /// What the surface takes of a whole run of `steps` steps, all ranks together: where the bodies stay whole,
  /// and where all that can be liquid falls apart into drops (the same without liquid). Zero without the
  /// module.
  struct Forecast {
    double surfels = 0, surfelsTogether = 0, surfelsMost = 0, bytes = 0, updates = 0, frames = 0, seconds = 0,
           secondsMost = 0;
  };
  /// particles: at the end, with those of emitters. Collective.
  Forecast forecast(double steps, double particles) const;
  const std::vector<std::uint64_t>& lumps() const { return tools_.lumps; }
  const std::vector<BodyPieces>& pieces() const { return tools_.pieces; }
  /// What `thaw check` prints, for this many ranks. Collective.
  std::vector<std::string> lines(const Forecast& forecast, int ranks) const;

 private:
  const Communicator& comm_;
  World& world_;
  double expected_ = 0, spacing_ = 0;  // m, that the scene wants
  double perMeasured_ = 1;             // surfels that are expected, for each one that is measured
  SurfaceRanks halos_;
  SurfaceTools tools_;
  std::int64_t surfels_ = 0;                               // of all ranks, after the start
  double bytes_ = 0, start_ = 0, each_ = 0, flowing_ = 0;  // of one update as it is at the start, and as of
                                                           // melt

  const CellGrid& gridOfTrial(const MeshLoader& load);
  double timeOfUpdate();
};

/// About how many updates of the surface a run has: one at each frame, and between them as the scene says,
/// for moves of particles at half of the largest speed that is expected of the scene.
double expectedUpdates(const World& world, double steps);

}  // namespace thaw
