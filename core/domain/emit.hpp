// Emitters: layers of particles that leave a disc or a rectangle one after another.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/scene/scene.hpp"
#include "core/particles/continuum.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// An emitter made ready: the places of one layer and the time between layers.
struct EmitterPlan {
  std::vector<Vec3d> layer;   ///< m, positions of a layer at the moment it leaves
  double interval = 0;        ///< s between layers
  double particleMass = 0;    ///< kg
};

/// Throws std::runtime_error (one sentence) where the rate asks for more particles than the opening lets through.
std::vector<EmitterPlan> planEmitters(const Scene& scene);

/// Number of the first layer that leaves after `time` (s); layers [layersUntil(a), layersUntil(b)) leave in (a, b].
std::int64_t layersUntil(const Emitter& emitter, const EmitterPlan& plan, double time);

}  // namespace thaw
