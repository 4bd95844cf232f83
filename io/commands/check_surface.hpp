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
  /// Without the module it does nothing. Collective.
  SurfaceTrial(const Communicator& comm, World& world, const MeshLoader& load);
  /// One update, after a few steps. Collective.
  void update();
  /// What `thaw check` prints, for this many ranks. Collective.
  std::vector<std::string> lines(int ranks);

 private:
  const Communicator& comm_;
  World& world_;
  SurfaceRanks halos_;
  SurfaceTools tools_;
  double expected_ = 0, bytes_ = 0, start_ = 0, each_ = 0;
};

/// What looks unwise in [surface], a line each.
std::vector<std::string> surfaceAdvice(const Scene& scene);

}  // namespace thaw
