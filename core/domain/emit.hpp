// Emitters: layers of particles that leave a disc or a rectangle one after another. A layer is made a few
// spacings behind the opening and driven through this nozzle at the emitter's speed, whatever presses on it:
// what has left is pushed on as by a piston, and no particle is ever put where there is one already.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// An emitter made ready: the places of one layer and the time between layers.
struct EmitterPlan {
  std::vector<Vec3d> layer;         ///< m, positions of a layer at the moment it leaves
  std::vector<double> along;        ///< m, of each along the opening's first axis, ascending
  std::vector<Vec3d> velocity;      ///< m/s, of each; empty: the emitter's speed along its direction
  std::vector<double> temperature;  ///< K, of each; empty: the emitter's
  double interval = 0;              ///< s between layers
  double ahead = 0;                 ///< s that a layer spends in the nozzle
  double particleMass = 0;          ///< kg
  std::vector<std::vector<double>> cohesion;  ///< J, [m][k]: of surface tension between particle k of a layer
                                              ///< and the layer m before it (0: half of its own); as a
                                              ///< stress: what stacks of more than m layers gain beyond the
                                              ///< stack before
};

/// Throws ShapeError where the rate asks for more particles than the opening lets through, and where a field
/// of the opening has a bad value, changes the speed along the direction, or moves neighbours in the nozzle.
std::vector<EmitterPlan> planEmitters(const Scene& scene);

/// One sentence on an emitter whose opening is not all in the domain, or is in an obstacle; empty: there is
/// nothing to say. (A nozzle ends where the domain does, and may lie in an obstacle.)
std::string misplacedOpening(const Scene& scene, const Walls& walls, const Emitter& emitter,
                             const EmitterPlan& plan);

/// kg/s that it lets out while it is open.
inline double outflowOf(const EmitterPlan& plan) {
  return static_cast<double>(plan.layer.size()) * plan.particleMass / plan.interval;
}

/// One sentence on an emitter that lets out far more or less than opening, speed and density say, since its
/// layers have whole spacings; empty: it does not.
std::string unevenOutflow(const Scene& scene, const Emitter& emitter, const EmitterPlan& plan);

/// Number of the first layer that is made after `time` (s); layers [layersUntil(a), layersUntil(b)) are made
/// in (a, b].
std::int64_t layersUntil(const Emitter& emitter, const EmitterPlan& plan, double time);

/// Energy (J) of surface tension that a particle of a layer brings when it is made behind those that are in
/// the nozzle.
double cohesionAtEntry(const EmitterPlan& plan, std::int64_t layer, std::size_t k);

/// Time (s) at which a layer leaves the opening.
double leavingTime(const Emitter& emitter, const EmitterPlan& plan, std::int64_t layer);

/// Ids say where a particle comes from: body or emitter ("source"), and a number within it.
inline constexpr int idBits = 40;
inline std::uint64_t particleId(std::uint64_t source, std::uint64_t number) {
  return source << idBits | number;
}
inline std::uint64_t sourceOf(std::uint64_t id) { return id >> idBits; }
inline std::uint64_t numberOf(std::uint64_t id) { return id & ((std::uint64_t(1) << idBits) - 1); }

/// Lets go of the driven particles whose layer has left by `time` (s).
void releaseDriven(const Scene& scene, const std::vector<EmitterPlan>& plans, double time,
                   Continuum& particles);

}  // namespace thaw
