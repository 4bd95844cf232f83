// SPDX-License-Identifier: Apache-2.0
// Forces and heat that a program adds to the particles of a simulation.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/heat/heat_view.hpp"
#include "core/ledger/ledger.hpp"
#include "core/particles/continuum.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// The input and output of an outside source. Arrays have one entry for each owned row of `particles`, whose
/// positions and velocities are those at `time`.
struct OutsideLoad {
  Continuum& particles;
  double time;         ///< s
  Vec3d* force;        ///< N, the source adds to it
  double* heat;        ///< W, the source adds to it; null in a scene without heat
  double dt;           ///< s, length of the step that ends at `time`; 0 at the start of a run
  HeatView run;        ///< scene, modules, ledger; its clock is at the beginning of the step
  const Walls& walls;  ///< obstacles and sides of the domain, at `time`
  Reducer& all;        ///< reductions over all ranks
  const std::vector<std::uint8_t>* steady;  ///< rows without force and heat (WallContext::steady), or null
};

/// Called once in every evaluation of forces, on every rank, including ranks without particles. A load must
/// give the same bits on any number of ranks. It may therefore use only the particle's own fields, the scene,
/// the walls and the time. It may also use exact sums and maxima over all ranks.
using OutsideSource = std::function<void(const OutsideLoad&)>;

/// Returns true if a particle is neither clamped nor sleeping, so that forces move it.
bool isFree(const Continuum& particles, std::size_t row);

/// Sets Continuum::outsideForce from all sources, and adds it to the forces of particles that are free to
/// move. Heat is added to Continuum::heatFlow and recorded for the step in the ledger. The arrays of
/// `load` are replaced.
void addOutsideLoads(const std::vector<OutsideSource>& sources, OutsideLoad load);

/// The half kick that follows. First: with the accelerations of the last step. Second: with the forces of
/// this step.
enum class HalfKick { First, Second };

/// Records work and impulse of a force (N) on a row in the half kick, at the mean velocity of the kick. Call
/// it before the kick. gravity: m/s^2; dt: s, the length of the whole step.
struct KickOfForce {
  HalfKick kick;
  Vec3d gravity;
  double dt;
  void record(const Continuum& particles, std::size_t row, const Vec3d& force, Ledger& ledger) const;
};

/// Records work and impulse of Continuum::outsideForce in a half kick over dt / 2 (s). Call it before the
/// kick. gravity: m/s^2.
void recordOutsideKick(const Continuum& particles, HalfKick kick, const Vec3d& gravity, double dt,
                       Ledger& ledger);

}  // namespace thaw
