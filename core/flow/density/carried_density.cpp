// SPDX-License-Identifier: Apache-2.0
#include "core/flow/density/carried_density.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "core/flow/density/connected_density.hpp"
#include "core/fluid/laws/free_surface.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/particles/step_velocity.hpp"
#include "core/walls/wall_forces.hpp"
#include "core/walls/wall_moments.hpp"

namespace thaw {
namespace {

/// Slope of the wall's part of the relative density, times h. The wall's pressure force (wall_forces.cpp)
/// uses the same slope, so force and density rate are adjoint.
double wallSlope(const CarryContext& x, const WallContact& c) {
  return x.inverseLatticeSum * x.wallTables(c.distance / x.grid.support).push * c.share;
}

/// Gradient of the wall's own relative density, times h: half of the slope.
Vec3d ownGradient(const CarryContext& x, const WallContact& c) { return c.normal * (-0.5 * wallSlope(x, c)); }

/// Velocity (m/s) relative to the wall in the last step: without shifting, and with it.
StepVelocity relativeVelocity(const CarryContext& x, const WallContact& c) {
  const StepVelocity v = stepVelocity(x.particles, c.row, x.clock.substeps);
  const Vec3d wall = wallVelocity(x.walls.list[c.wall], x.particles.position[c.row]);
  return {v.flow - wall, v.all - wall};
}

/// Moves a contact back to the start of the step. Beyond `edgeReach` spacings the wall is treated as a plane.
/// At smaller distances, its normal turns where the particle passes a convex edge. With the normal at the
/// end of the step, the work at such an edge would have a first-order error. nearest: the contact is with the
/// wall's nearest face.
void moveToStart(const CarryContext& x, WallContact& c, bool nearest) {
  constexpr double edgeReach = 1, smallestTurn = 0.01;  // rad, smaller turns are neglected
  const Continuum& p = x.particles;
  const Vec3d back = relativeVelocity(x, c).all * -x.dt;
  const double off = dot(back, c.normal), along = length(back - c.normal * off);
  c.distance += off;
  if (!nearest || c.distance > edgeReach * x.scene.spacing) return;
  if (along <= smallestTurn * std::max(c.distance, 0.0)) return;
  const Wall& wall = x.walls.list[c.wall];
  Vec3d normal;
  const double distance = wall.shape->distance(toRest(wall.pose, p.position[c.row] + back), &normal);
  // If it is less than the distance from the plane, it belongs to another face of a concave wall. That face
  // has its own contact.
  if (distance <= c.distance + 1e-3 * along) return;
  c.distance = distance;
  c.normal = directionFromRest(wall.pose, normal);
}

/// Returns the contacts of a row at the start of the step, with their shares at that time.
std::span<const WallContact> atStart(const CarryContext& x, std::span<const WallContact> now) {
  std::vector<WallContact>& start = x.carry.startContacts;
  start.assign(now.begin(), now.end());
  for (std::size_t k = 0; k < start.size(); k++)
    moveToStart(x, start[k], k == 0 || now[k - 1].wall != now[k].wall);
  if (start.size() > 1)
    for (std::size_t k = 0; k < start.size(); k++)
      start[k].share = pressureShare({x.wallTables, x.grid.support}, start, k);
  return start;
}

/// Rate (1/s) of the relative density due to a wall.
double wallRate(const CarryContext& x, const WallContact& c) {
  return -wallSlope(x, c) / x.grid.support * dot(relativeVelocity(x, c).flow, c.normal);
}

/// Adds the walls' parts to the sums of a row. The walls' density rate is the mean of its values at both
/// ends of the step, like the work of the wall forces. The change of compression energy then equals this work
/// to second order, even where walls overlap.
void addWallsTo(const void* context, std::uint32_t row, CarryRow& r) {
  const CarryContext& x = *static_cast<const CarryContext*>(context);
  WallContacts& contacts = x.wallContacts;
  const std::span<const WallContact> mine = contactsOf(contacts, row);
  const double h = x.grid.support;
  r.relativeDensity += x.inverseLatticeSum * wallRelativeDensity({x.wallTables, h}, mine, contacts.added);
  for (const WallContact& c : mine) r.gradient += ownGradient(x, c);
  double rates = 0;
  for (const WallContact& c : atStart(x, mine)) rates += wallRate(x, c);
  for (const WallContact& c : mine) rates += wallRate(x, c);
  r.rate += 0.5 * r.liquidFraction * rates;
  r.atSurface = r.liquidFraction > 0 &&
                length(alongWalls(r.gradient, mine, x.scene.spacing)) > surfaceAsymmetry * r.gradientSize;
  r.moment = alongAllWalls(r.moment, mine, h);
}

Vec3d alongWallsOf(const void* context, std::uint32_t row, Vec3d velocity) {
  const CarryContext& x = *static_cast<const CarryContext*>(context);
  return alongWalls(velocity, contactsOf(x.wallContacts, row), x.scene.spacing);
}

/// Returns whether this step stores the summed densities.
bool storesSums(const CarryContext& x) {
  constexpr std::int64_t everySteps = 16;
  return x.dt == 0 || x.clock.step % everySteps == 0;
}

}  // namespace

void beginCarry(const CarryContext& x) {
  const std::size_t rows = x.particles.owned;
  CarryWork& work = x.carry;
  work.besideWall.clear();
  if (!x.wallContacts.list.empty()) {
    work.besideWall.assign(rows, 0);
    for (const WallContact& c : x.wallContacts.list) work.besideWall[c.row] = 1;
  }
  if (storesSums(x)) work.summed.assign(rows, 0);
  x.counters.crowded = 0;
  work.largestChange = 0;
}

CarryStep carryStepOf(const CarryContext& x) {
  Continuum& p = x.particles;
  const Numerics& n = x.scene.numerics;
  const double dt = x.dt;
  CarryStep s;
  s.dt = dt;
  s.ahead = dt > 0 ? dt / (dt + x.clock.stepDt) : 0;
  s.diffusion = n.densityDiffusion;
  s.shifting = n.shifting;
  s.weight = x.scene.domain.gravity * x.grid.support;
  s.eos = n.eos;
  s.tensileLimit = n.tensileLimit;
  s.liquids = x.liquids.data();
  s.material = p.material.data();
  s.mass = p.mass.data();
  if (p.restDensity.active) s.restDensity = p.restDensity.data();
  if (x.modules.sleep) s.steady = x.steady.data();
  s.corrected = x.modules.corrected;
  s.surfaces = p.atSurface.active;
  s.solids = x.modules.solid;
  if (!x.carry.besideWall.empty()) s.walls = {&x, x.carry.besideWall.data(), addWallsTo, alongWallsOf};
  s.compression = p.compression.data();
  s.dissipated = p.dissipated.data();
  s.midCorrection = p.midCorrection.data();
  s.correction = p.correction.data();
  s.atSurface = p.atSurface.data();
  s.shiftingVelocity = p.shiftingVelocity.data();
  if (p.compressionRate.active) s.compressionRate = p.compressionRate.data();
  if (p.relief.active) s.relief = p.relief.data();
  if (storesSums(x)) s.summed = x.carry.summed.data();
  s.largestChange = &x.carry.largestChange;
  s.crowded = &x.counters.crowded;
  return s;
}

void resetCarriedDensity(const CarryStep& x, float* relativeDensity, std::uint32_t row) {
  const LiquidMaterial& m = x.liquids[x.material[row]];
  if (x.compression[row] != 0)
    x.dissipated[row] += (x.restDensity ? x.mass[row] / x.restDensity[row] : x.mass[row] * m.restVolume) *
                         compressionEnergy(x.eos, m.stiffness, 1 + x.compression[row], x.tensileLimit);
  x.compression[row] = 0;
  relativeDensity[row] = 1;
  if (x.compressionRate) x.compressionRate[row] = 0;
  if (x.corrected) x.midCorrection[row] = x.correction[row] = {};
  if (x.surfaces) {
    x.atSurface[row] = 0;
    x.shiftingVelocity[row] = {};
  }
  if (x.relief) x.relief[row] = {};
}

namespace {

/// Resets the particles of groups without liquid, which the sums skip.
void resetDryGroups(const CarryContext& x) {
  const NeighbourLists& lists = x.neighbours;
  const CarryStep step = carryStepOf(x);
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8 && !lists.fluid[g]; l++) {
      const std::uint32_t row = lists.self[8 * g + l];
      if (row != lists.dummy && !(step.steady && step.steady[row]))
        resetCarriedDensity(step, x.particles.relativeDensity.data(), row);
    }
}

}  // namespace

void finishCarry(const CarryContext& x) {
  if (x.modules.solid) resetDryGroups(x);
  if (!storesSums(x)) return;
  if (x.dt == 0) x.initialSummedDensity = x.carry.summed;
  const std::array<std::int64_t, 2> sums = connectedSums(x.particles, x.neighbours, x.carry.summed);
  x.counters.connected = sums[0];
  x.counters.connectedDensity = sums[1];
}

void shiftInside(const CarryContext& x) {
  Continuum& p = x.particles;
  for (const WallContact& c : x.wallContacts.list)
    p.concentrationGradient[c.row] += single(ownGradient(x, c));
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool inside = liquidFraction(p, i) == 1 && static_cast<double>(p.relativeDensity[i]) > 0.9;
    p.shiftingVelocity[i] = inside ? wide(p.concentrationGradient[i]) *
                                         (-x.scene.numerics.shifting * x.liquids[p.material[i]].soundSpeed)
                                   : Vec3d{};
  }
}

}  // namespace thaw
