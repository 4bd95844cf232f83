// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/density/carried_density.hpp"

#include <algorithm>

#include "core/fluid/density/connected_density.hpp"
#include "core/fluid/density/free_surface.hpp"
#include "core/fluid/density/lattice_relief.hpp"
#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw {
namespace {

/// Adds the walls' part of the concentration gradient and of the density rate. The slope is that of the
/// wall's pressure force (wall_forces.cpp), so that the two are adjoint. dt: last step (s); the rate uses
/// distances at mid-step, as pairs do.
void addWalls(World& w, const StepTools& t, double dt) {
  Continuum& p = w.particles;
  const double h = w.grid.support;
  for (const WallContact& c : t.wallContacts.list) {
    const double push = t.perLatticeSum * t.wallTables(c.distance / h).push * c.share;
    // push is twice the gradient of the wall's own relative density
    if (p.concentrationGradient.active) p.concentrationGradient[c.row] += single(c.normal * (-0.5 * push));
    if (!p.densityRate.active) continue;
    const double off = dot(p.velocity[c.row] - wallVelocity(w.walls.list[c.wall], p.position[c.row]),
                           c.normal);
    const double middle = t.perLatticeSum * t.wallTables((c.distance - 0.5 * dt * off) / h).push * c.share;
    p.densityRate[c.row] -= liquidFraction(p, c.row) * middle / h * off;
  }
}

/// Shifting with a summed density: inside, from crowded to empty places. Not at a free surface, where the
/// gradient is its normal.
void shiftInside(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool inside = liquidFraction(p, i) == 1 && static_cast<double>(p.relativeDensity[i]) > 0.9;
    p.shiftingVelocity[i] = inside ? wide(p.concentrationGradient[i]) *
                                         (-w.scene.numerics.shifting * t.liquids[p.material[i]].soundSpeed)
                                   : Vec3d{};
  }
}

/// Interior weight: 0 up to a summed relative density of 0.9 (truncated by a free surface), 1 from 0.95.
double shareInside(double relativeDensity) { return std::clamp((relativeDensity - 0.9) / 0.05, 0.0, 1.0); }

enum class Layer { Inside, BesideSurface, Surface };

Layer layerOf(const Continuum& p, std::size_t i) {
  return p.atSurface[i] ? Layer::Surface : besideSurface(p, i) ? Layer::BesideSurface : Layer::Inside;
}

/// Drift correction: change of the carried relative density in this step towards the summed one.
/// Shifting, splashing and clipped tension move particles without changing the carried density.
/// Inside the liquid the correction is slow, so that disorder causes no pressure noise; it never makes
/// tension. Next to the free surface it only counts what the truncated sum cannot explain, such as voids of a
/// splash. An excess above `tolerated` decays faster, also at the surface. off: summed less carried relative
/// density; steps: c dt / h.
double driftCorrection(double off, double compression, Layer layer, double steps) {
  constexpr double perStep = 0.01, crowdedPerStep = 0.05, tolerated = 0.03, truncated = 0.1;
  const double drift = layer == Layer::Inside          ? off
                       : layer == Layer::BesideSurface ? std::min(0.0, off + truncated)
                                                       : 0;
  const double back = std::max(std::min(1.0, perStep * steps) * drift, -std::max(0.0, compression));
  return back + std::min(1.0, crowdedPerStep * steps) * std::max(0.0, off - tolerated);
}

/// Moment at a wall, with 1 along the normal. The sums contain only liquid neighbours, as the gradient does
/// along the wall. Along the normal the wall's push already balances a uniform pressure.
Sym3f alongWall(const Sym3f& moment, const Vec3d& normal) {
  const Vec3f n = single(normal), m = moment * n;
  const Vec3f k = m - n * (0.5F * (dot(n, m) + 1));  // M - n m^T - m n^T + (n.m + 1) n n^T
  return {moment.xx - 2 * n.x * k.x,         moment.yy - 2 * n.y * k.y,
          moment.zz - 2 * n.z * k.z,         moment.xy - n.x * k.y - n.y * k.x,
          moment.yz - n.y * k.z - n.z * k.y, moment.xz - n.x * k.z - n.z * k.x};
}

/// Inverse moment minus 1, times the interior weight. 0 where an eigenvalue is below 0.4: corrections above
/// 2.5 would be unstable at this step.
Sym3d correctionOf(const Sym3f& moment, double relativeDensity) {
  const double weight = shareInside(relativeDensity);
  const Sym3d m = wide(moment);
  if (weight <= 0 || !eigenvaluesAbove(m, 0.4)) return {};
  const double xx = m.yy * m.zz - m.yz * m.yz, xy = m.xz * m.yz - m.xy * m.zz, xz = m.xy * m.yz - m.xz * m.yy;
  const double k = weight / (m.xx * xx + m.xy * xy + m.xz * xz);
  return {k * xx - weight, k * (m.xx * m.zz - m.xz * m.xz) - weight, k * (m.xx * m.yy - m.xy * m.xy) - weight,
          k * xy,          k * (m.xy * m.xz - m.xx * m.yz),          k * xz};
}

/// Share of the difference to liquid nearby that a solid's density makes up per acoustic time h/c [A12]. The
/// liquid nearby is that of the step before, so a share near 1 would feed sound.
constexpr double towardsLiquidNearby = 0.5;

struct CarryContext {
  World& world;
  const std::vector<LiquidMaterial>& liquids;
  double dt;
  double ahead;  ///< extrapolation factor of the correction: (end - mid-step) / (mid-step - previous
                 ///< mid-step)
  const Numerics& numerics() const { return world.scene.numerics; }
};

/// Adds the corrected divergence at mid-step to the rate. Extrapolates the correction from the last two
/// mid-steps to the end of the step, with a limited change.
void correct(const CarryContext& x, std::size_t i) {
  Continuum& p = x.world.particles;
  constexpr float most = 0.1F;
  const Sym3f d = single(correctionOf(p.moment[i], static_cast<double>(p.relativeDensity[i]))),
              before = p.midCorrection[i];
  const Mat3f& u = p.negativeVelocityGradient[i];
  p.densityRate[i] += static_cast<double>(
      (1 + d.xx) * u.row[0].x + (1 + d.yy) * u.row[1].y + (1 + d.zz) * u.row[2].z +
      d.xy * (u.row[0].y + u.row[1].x) + d.yz * (u.row[1].z + u.row[2].y) + d.xz * (u.row[0].z + u.row[2].x));
  const float ahead = static_cast<float>(x.ahead);
  const auto next = [&](float now, float last) { return now + ahead * std::clamp(now - last, -most, most); };
  p.correction[i] = {next(d.xx, before.xx), next(d.yy, before.yy), next(d.zz, before.zz),
                     next(d.xy, before.xy), next(d.yz, before.yz), next(d.xz, before.xz)};
  p.midCorrection[i] = d;
}

/// Resets the carried density of a particle without liquid around it; its compression energy is dissipated.
void resetCarriedDensity(const CarryContext& x, std::size_t i) {
  Continuum& p = x.world.particles;
  const LiquidMaterial& m = x.liquids[p.material[i]];
  const Numerics& n = x.numerics();
  if (p.compression[i] != 0)
    p.dissipated[i] += p.mass[i] * m.restVolume *
                       compressionEnergy(n.eos, m.stiffness, 1 + p.compression[i], n.tensileLimit);
  p.compression[i] = 0;
  p.relativeDensity[i] = 1;
  if (p.correction.active) p.midCorrection[i] = p.correction[i] = {};
}

/// Integrates the carried relative density over the step. Records the compression energy that diffusion and
/// drift correction change.
void carry(const CarryContext& x, std::size_t i) {
  Continuum& p = x.world.particles;
  const LiquidMaterial& m = x.liquids[p.material[i]];
  const Numerics& n = x.numerics();
  const double before = p.compression[i], flow = before + p.densityRate[i] * x.dt;
  const double summed = static_cast<double>(p.relativeDensity[i]);
  double spread = p.densityDiffusionRate[i] * x.dt;
  const bool solid = p.liquidKernelSum.active && liquidFraction(p, i) == 0;
  const double steps = m.soundSpeed * x.dt / x.world.grid.support;
  if (solid)
    spread += std::min(1.0, towardsLiquidNearby * steps) * (static_cast<double>(p.liquidNearby[i]) - before);
  else if (p.atSurface.active && liquidFraction(p, i) == 1)
    spread += driftCorrection(summed - 1 - flow - spread, flow + spread, layerOf(p, i), steps);
  const auto slope = [&](double y) {
    return pressureOf(n.eos, m.stiffness, 1 + y, n.tensileLimit) / ((1 + y) * (1 + y));
  };
  // mean of both ends of the step, as for the pressure work of the flow
  p.dissipated[i] -= 0.5 * p.mass[i] * m.restVolume * spread *
                     (slope(flow + 0.5 * spread) + slope(before + 0.5 * spread));
  p.compression[i] = flow + spread;
  p.relativeDensity[i] = static_cast<float>(1 + p.compression[i]);
}

/// Stores the summed densities that later checks need, before the carried ones replace them.
void noteSummedDensity(World& w, double dt) {
  constexpr std::int64_t everySteps = 16;
  if (dt == 0)
    w.startDensity.assign(w.particles.relativeDensity.data(),
                          w.particles.relativeDensity.data() + w.particles.owned);
  if (dt != 0 && w.clock.step % everySteps != 0) return;
  const std::array<std::int64_t, 2> sums = connectedSums(w);
  w.counters.connected = sums[0];
  w.counters.connectedDensity = sums[1];
}

/// True for liquid, partly molten particles, and solids near liquid. Such solids carry the liquid's density.
bool carriesDensity(const Continuum& p, std::size_t i) {
  return p.liquidKernelSum.active ? p.liquidKernelSum[i] > 0 : true;
}

}  // namespace

void carryDensity(World& w, const StepTools& t, double dt) {
  Continuum& p = w.particles;
  addWalls(w, t, dt);
  if (p.atSurface.active) findFreeSurface(w, t);
  else if (w.modules.shifting) shiftInside(w, t);
  if (!w.modules.continuity) return;
  if (w.modules.corrected)
    for (const WallContact& c : t.wallContacts.list) p.moment[c.row] = alongWall(p.moment[c.row], c.normal);
  noteSummedDensity(w, dt);
  constexpr double tooCrowded = 1.3;
  w.counters.crowded = 0;
  const CarryContext x{w, t.liquids, dt, dt > 0 ? dt / (dt + w.clock.stepDt) : 0};
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.atSurface.active) p.shiftingVelocity[i] = shiftOf(w, t, i);
    if (w.modules.sleep && t.sleep.steady[i])
      continue;  // skipped: its sums are not computed and do not change
    if (!carriesDensity(p, i)) {
      resetCarriedDensity(x, i);
      continue;
    }
    const bool crowded = static_cast<double>(p.relativeDensity[i]) > tooCrowded * (1 + p.compression[i]);
    w.counters.crowded += crowded && liquidFraction(p, i) > 0;
    if (w.modules.corrected) correct(x, i);
    carry(x, i);
  }
  if (p.relief.active) {
    const std::span<const std::uint8_t> asleep = w.modules.sleep ? t.sleep.steady
                                                                 : std::span<const std::uint8_t>{};
    findLatticeRelief({t.liquids, w.scene.numerics, w.grid.support, asleep}, p);
  }
  if (p.atSurface.active) shiftAlongWalls(w, t);
}

}  // namespace thaw
