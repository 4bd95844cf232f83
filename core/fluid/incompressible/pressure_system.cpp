// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/incompressible/pressure_system.hpp"

#include <array>

#include "core/fluid/incompressible/pressure_records.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {
namespace {

using Sweep = void (*)(const PairSums&, GroupRange);
using Pack = void (*)(const RecordContext&, const Continuum&, std::size_t, std::size_t, PairRecords&);

PairSums sumsOf(const PressureSystem& x) {
  PairSums s = pairSumsOf(x.world, x.tools);
  s.impulse = x.tools.pressure.impulse.data();
  s.compression = x.tools.pressure.rate.data();
  return s;
}

/// Evaluates a sum that reads a ghost column; inner particles are summed during the exchange.
void sumWith(const PressureSystem& x, AnyColumn& column, Pack pack, Sweep sweep) {
  World& w = x.world;
  StepTools& t = x.tools;
  Continuum& p = w.particles;
  const RecordContext records{w.scene, w.modules, w.grid, t.liquids};
  const PairSums s = sumsOf(x);
  x.halos.cells.beginRefresh(p, std::array<AnyColumn*, 1>{&column});
  pack(records, p, 0, p.owned, t.records);
  sweep(s, {0, w.neighbours.innerGroups});
  t.times.lap(StepPhase::Pressure);
  x.halos.cells.finishRefresh(p);
  t.times.lap(StepPhase::Exchange);
  pack(records, p, p.owned, p.size(), t.records);
  sweep(s, {w.neighbours.innerGroups, w.neighbours.groups});
}

double volumeOf(const World& w, std::size_t i) {
  return w.particles.mass[i] / w.scene.materials[w.particles.material[i]].density;
}

/// Gradients of the relative density due to walls, for all particles that are or can be liquid.
void findWallSlopes(const PressureSystem& x) {
  const World& w = x.world;
  PressureWork& work = x.tools.pressure;
  work.walls.clear();
  for (const WallContact& c : x.tools.wallContacts.list) {
    if (work.fraction[c.row] == 0) continue;
    const double push = x.tools.wallTables(c.distance / w.grid.support).push;
    work.walls.push_back({c.row, c.normal * (-x.tools.perLatticeSum * push * c.share / w.grid.support),
                          wallVelocity(w.walls.list[c.wall], w.particles.position[c.row])});
  }
}

}  // namespace

void prepareSystem(const PressureSystem& x) {
  World& w = x.world;
  Continuum& p = w.particles;
  PressureWork& work = x.tools.pressure;
  work.response.resize(p.owned);
  work.fraction.resize(p.owned);
  work.before.resize(p.owned);
  work.stepped.resize(p.owned);
  work.start.resize(p.owned);
  work.impulse.assign(p.owned, {});
  work.rate.assign(p.owned, 0);
  const RecordContext records{w.scene, w.modules, w.grid, x.tools.liquids};
  packMobility(records, p, p.size(), x.tools.records);
  for (std::size_t i = 0; i < p.owned; i++) work.fraction[i] = packedFraction(records, x.tools.records, i);
  findWallSlopes(x);

  x.tools.kernels->response(sumsOf(x), {0, w.neighbours.groups});
  for (const WallSlope& wall : work.walls) work.impulse[wall.row] += wall.slope;
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool still = p.clamped.active && p.clamped[i];
    const double own = still ? 0 : dot(work.impulse[i], work.impulse[i]) / p.mass[i],
                 f = static_cast<double>(work.fraction[i]);
    work.response[i] = f > 0 ? volumeOf(w, i) * (own + work.rate[i]) / f : 0;
  }
  x.tools.times.lap(StepPhase::Pressure);
}

void applyPressures(const PressureSystem& x) {
  World& w = x.world;
  Continuum& p = w.particles;
  PressureWork& work = x.tools.pressure;
  sumWith(x, p.trialPressure, packTrialPressure, x.tools.kernels->impulse);
  for (const WallSlope& wall : work.walls)
    work.impulse[wall.row] -= wall.slope *
                              (volumeOf(w, wall.row) * static_cast<double>(p.trialPressure[wall.row]));
  const bool clamps = p.clamped.active;
  for (std::size_t i = 0; i < p.owned; i++)
    p.trialVelocity[i] = clamps && p.clamped[i] ? work.start[i] : work.start[i] + work.impulse[i] / p.mass[i];
}

void relativeDensityRate(const PressureSystem& x) {
  Continuum& p = x.world.particles;
  sumWith(x, p.trialVelocity, packTrialVelocity, x.tools.kernels->compression);
  for (const WallSlope& wall : x.tools.pressure.walls)
    x.tools.pressure.rate[wall.row] += dot(wall.slope, p.trialVelocity[wall.row] - wall.velocity);
}

}  // namespace thaw
