// SPDX-License-Identifier: Apache-2.0
// Emitters create layers of particles that leave a disc or rectangle one after another. A layer is created a
// few spacings behind the opening and driven through this nozzle at the emitter's speed against any pressure.
// It pushes earlier layers like a piston, and no particle is created at an occupied position.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Prepared emitter: positions of one layer and time between layers.
struct EmitterPlan {
  std::vector<Vec3d> layer;     ///< m, positions of a layer at the moment it leaves
  std::vector<double> along;    ///< m, coordinate of each position along the opening's first axis, ascending
  std::vector<Vec3d> velocity;  ///< m/s, per position; empty: the emitter's speed along its direction
  std::vector<double> temperature;            ///< K, per position; empty: the emitter's temperature
  double interval = 0;                        ///< s between layers
  double ahead = 0;                           ///< s that a layer spends in the nozzle
  double particleMass = 0;                    ///< kg
  std::vector<std::vector<double>> cohesion;  ///< J, [m][k]: surface tension between particle k of a layer
                                              ///< and layer m before it (0: half of its own layer). As
                                              ///< surface energy: (E(m + 1) - 2 E(m) + E(m - 1)) / particles,
                                              ///< E(m) of a stack of m layers
};

/// Throws ShapeError if the rate needs more particles than the opening admits. It also throws if a field of
/// the opening has a bad value, changes the speed along the direction, or moves neighbours in the nozzle.
std::vector<EmitterPlan> planEmitters(const Scene& scene);

/// Returns a sentence if the emitter's opening is partly outside the domain or in an obstacle, else an empty
/// string. A nozzle ends at the domain and may lie in an obstacle.
std::string misplacedOpening(const Scene& scene, const Walls& walls, const Emitter& emitter,
                             const EmitterPlan& plan);

/// Mass flow (kg/s) while the emitter is open.
inline double outflowOf(const EmitterPlan& plan) {
  return static_cast<double>(plan.layer.size()) * plan.particleMass / plan.interval;
}

/// Returns a sentence if the mass flow differs much from opening area * speed * density, else an empty
/// string. Such differences arise since a layer has a whole number of particles.
std::string unevenOutflow(const Scene& scene, const Emitter& emitter, const EmitterPlan& plan);

/// Returns the number of layers created up to `time` (s): layers [layersUntil(a), layersUntil(b)) are created
/// in (a, b].
std::int64_t layersUntil(const Emitter& emitter, const EmitterPlan& plan, double time);

/// Surface tension energy (J) of a particle of a layer when it is created behind the layers in the nozzle.
double cohesionAtEntry(const EmitterPlan& plan, std::int64_t layer, std::size_t k);

/// Time (s) at which a layer leaves the opening.
double leavingTime(const Emitter& emitter, const EmitterPlan& plan, std::int64_t layer);

/// Number of bits of an id for the number of the particle within its source. Higher bits hold the number of
/// the body or emitter.
inline constexpr int idBits = 40;
inline std::uint64_t particleId(std::uint64_t source, std::uint64_t number) {
  return source << idBits | number;
}
inline std::uint64_t sourceOf(std::uint64_t id) { return id >> idBits; }
inline std::uint64_t numberOf(std::uint64_t id) { return id & ((std::uint64_t(1) << idBits) - 1); }

/// Releases the driven particles whose layer has left by `time` (s).
void releaseDriven(const Scene& scene, const std::vector<EmitterPlan>& plans, double time,
                   Continuum& particles);

}  // namespace thaw
