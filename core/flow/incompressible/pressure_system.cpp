// SPDX-License-Identifier: Apache-2.0
#include "core/flow/incompressible/pressure_system.hpp"

#include "core/flow/incompressible/gradient_correction.hpp"
#include "core/flow/incompressible/pressure_records.hpp"
#include "core/halo/exchange.hpp"
#include "core/materials/rest_density.hpp"

namespace thaw {
namespace {

using Sweep = void (*)(const PairSums&, GroupRange);
using Pack = void (*)(const RecordContext&, const Continuum&, std::size_t, std::size_t, PairRecords&);

PairSums sumsOf(const PressureSystem& x) {
  PairSums s = x.sums;
  s.impulse = x.pressure.impulse.data();
  s.compression = x.pressure.rate.data();
  s.moment = x.pressure.moment.data();
  s.otherResponse = x.pressure.otherResponse.data();
  if (x.scene.numerics.correctedGradients) s.correction = x.particles.correction.data();
  return s;
}

/// Evaluates a sum that reads a ghost column; inner particles are summed during the exchange.
void sumWith(const PressureSystem& x, AnyColumn& column, Pack pack, Sweep sweep) {
  Continuum& p = x.particles;
  const RecordContext records{x.scene, x.modules, x.grid, x.liquids};
  const PairSums s = sumsOf(x);
  Exchange ghosts = refresh(x.halos.cells, p, ColumnList{&column});
  pack(records, p, 0, p.owned, x.records);
  sweep(s, {0, x.neighbours.innerGroups});
  x.times.lap(StepPhase::Pressure);
  ghosts.wait();
  x.times.lap(StepPhase::Exchange);
  pack(records, p, p.owned, p.size(), x.records);
  sweep(s, {x.neighbours.innerGroups, x.neighbours.groups});
}

double volumeOf(const PressureSystem& x, std::size_t i) {
  return restVolumeOf(x.particles, x.scene.materials, i);
}

/// Gradients of the relative density due to walls, for all particles that are or can be liquid.
void findWallSlopes(const PressureSystem& x) {
  PressureWork& work = x.pressure;
  work.walls.clear();
  for (const WallContact& c : x.wallContacts.list) {
    if (work.fraction[c.row] == 0) continue;
    const double push = x.wallTables(c.distance / x.grid.support).push;
    work.walls.push_back({c.row, c.normal * (-x.inverseLatticeSum * push * c.share / x.grid.support),
                          wallVelocity(x.walls.list[c.wall], x.particles.position[c.row])});
  }
}

/// Responses from the sums of PairKernels::response, with corrected gradients.
void findResponses(const PressureSystem& x) {
  Continuum& p = x.particles;
  PressureWork& work = x.pressure;
  const bool corrected = x.scene.numerics.correctedGradients;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Mat3d L = identity3<double>() + (corrected ? full(wide(p.correction[i])) : Mat3d{});
    work.impulse[i] = L * work.impulse[i];
    work.rate[i] = doubleDot(symmetric(L * L), work.otherResponse[i]);
  }
  for (const WallSlope& wall : work.walls) work.impulse[wall.row] += wall.slope;
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool still = p.clamped.active && p.clamped[i];
    const double own = still ? 0 : dot(work.impulse[i], work.impulse[i]) / p.mass[i],
                 f = static_cast<double>(work.fraction[i]);
    work.response[i] = f > 0 ? volumeOf(x, i) * (own + work.rate[i]) / f : 0;
  }
}

}  // namespace

void prepareSystem(const PressureSystem& x) {
  Continuum& p = x.particles;
  PressureWork& work = x.pressure;
  work.response.resize(p.owned);
  work.fraction.resize(p.owned);
  work.before.resize(p.owned);
  work.stepped.resize(p.owned);
  work.start.resize(p.owned);
  work.inside.assign(p.owned, 0);
  work.impulse.assign(p.owned, {});
  work.moment.assign(p.owned, {});
  work.otherResponse.assign(p.owned, {});
  work.rate.assign(p.owned, 0);
  const RecordContext records{x.scene, x.modules, x.grid, x.liquids};
  packMobility(records, p, p.size(), x.records);
  for (std::size_t i = 0; i < p.owned; i++) work.fraction[i] = packedFraction(records, x.records, i);
  findWallSlopes(x);

  x.kernels.response(sumsOf(x), {0, x.neighbours.groups});
  if (x.scene.numerics.correctedGradients) correctGradients(x);
  findResponses(x);
  x.times.lap(StepPhase::Pressure);
}

void applyPressures(const PressureSystem& x) {
  Continuum& p = x.particles;
  PressureWork& work = x.pressure;
  sumWith(x, p.trialPressure, packTrialPressure, x.kernels.impulse);
  for (const WallSlope& wall : work.walls)
    work.impulse[wall.row] -= wall.slope *
                              (volumeOf(x, wall.row) * static_cast<double>(p.trialPressure[wall.row]));
  const bool clamps = p.clamped.active;
  if (x.joint) {
    for (std::size_t i = 0; i < p.owned; i++)
      p.trialVelocity[i] = clamps && p.clamped[i] ? Vec3d{} : work.impulse[i] / p.mass[i];
    x.joint->join({p.trialVelocity.data(), p.owned});
    for (std::size_t i = 0; i < p.owned; i++) p.trialVelocity[i] += work.start[i];
    return;
  }
  for (std::size_t i = 0; i < p.owned; i++)
    p.trialVelocity[i] = clamps && p.clamped[i] ? work.start[i] : work.start[i] + work.impulse[i] / p.mass[i];
}

void relativeDensityRate(const PressureSystem& x) {
  Continuum& p = x.particles;
  sumWith(x, p.trialVelocity, packTrialVelocity, x.kernels.compression);
  for (const WallSlope& wall : x.pressure.walls)
    x.pressure.rate[wall.row] += dot(wall.slope, p.trialVelocity[wall.row] - wall.velocity);
}

}  // namespace thaw
