// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/relax_packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/domain/sides.hpp"
#include "core/geometry/sampling/sampling.hpp"
#include "core/halo/exchange.hpp"
#include "core/kernels/lattice.hpp"
#include "core/materials/rest_density.hpp"
#include "core/scene/full_box.hpp"
#include "core/simulation/setup/packing_sums.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {
namespace {

constexpr int iterations = 30, densityRelaxationIterations = 200;
constexpr double densityTolerance = 1e-4;  // excess of relative density, which corresponds to a pressure of
                                           // 1e-4 rho c^2

/// Computes sums of grad W over all neighbours, as the pressure force of a liquid with unit pressure.
void kernelGradients(World& w, Halos& halos, StepTools& t) {
  Continuum& p = w.particles;
  computeCellKeys(w.grid, p);
  if (p.ghosts > 0) p.resize(p.owned, 0);
  const Migration m = halos.cells.migrate(p, {p.nextCell.data(), p.owned});
  computeCellKeys(w.grid, p);
  if (p.solidIndex.active)
    for (std::size_t i = 0; i < p.owned; i++) p.solidIndex[i] = noSolid;
  sortByCell(p, m, t.redistribution.sort, w.cells);
  sendGhosts(halos.cells, p, w.cells, t.phases.ghosts.withPositions).wait();
  clearRates(w.particles);
  markInner(w.cells, p.owned, halos.cells, t.sums.inner);
  t.sums.ghostRoom = std::max(t.sums.ghostRoom, p.ghosts);
  sumUnitPressure(w, t.liquids, t.sums);
}

/// Returns, by body, 1 if it is relaxed and none of its particles is within range of a wall. A wall would
/// constrain the body.
std::vector<std::uint8_t> freeBodies(const World& w, Halos& halos, const std::vector<std::uint8_t>& relaxed) {
  std::vector<double> atWall(w.scene.bodies.size(), 0.0);
  for (std::size_t i = 0; i < w.particles.owned; i++) {
    const std::size_t body = w.particles.body[i];
    if (!relaxed[body] || atWall[body] > 0) continue;
    for (const Wall& wall : w.walls.list) {
      const Vec3d x = toRest(wall.pose, w.particles.position[i]);
      if (wall.present && nearBounds(wall.bounds, x, w.grid.support) &&
          wall.shape->distance(x) < w.grid.support)
        atWall[body] = 1;
    }
  }
  halos.all.maximum(atWall);
  std::vector<std::uint8_t> free = relaxed;
  for (std::size_t b = 0; b < atWall.size(); b++)
    if (atWall[b] > 0) free[b] = 0;
  return free;
}

/// Relaxes the density. After the iterations on kernel gradients, the density is locally up to 3 % too large.
/// Lattice points of a shape may also have one per cent more volume than the shape. If released in free
/// space, the liquid would gain some thousandths of the sound speed from these pressures and swell
/// permanently. Particles move along the negative gradient of the sum of squared excesses, out of their shape
/// if necessary. Returns the number of iterations.
int relaxDensity(World& w, Halos& halos, StepTools& t, const std::vector<std::uint8_t>& moves) {
  Continuum& p = w.particles;
  const double dx = w.scene.spacing, slope = largestRelativeDensityGradient(w.scene.numerics) *
                                             t.sums.scales.inverseLatticeSum / w.grid.support;
  if (std::find(moves.begin(), moves.end(), 1) == moves.end()) return 0;
  for (int k = 0; k < densityRelaxationIterations; k++) {
    kernelGradients(w, halos, t);
    sumExcessPressure(w, halos.cells, t.liquids, t.sums);
    double excess = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      if (p.phase[i] == Liquid && moves[p.body[i]])
        excess = std::max(excess, static_cast<double>(p.relativeDensity[i]) - 1);
    halos.all.maximum({&excess, 1});
    if (excess < densityTolerance) return k;
    for (std::size_t i = 0; i < p.owned; i++) {
      if (p.phase[i] != Liquid || !moves[p.body[i]]) continue;
      const double density = restDensityOf(p, w.scene.materials, i);
      Vec3d move = p.force[i] * (density / p.mass[i] * 1.5 / (slope * slope));
      const double length2 = dot(move, move), most = 0.1 * dx;
      if (length2 > most * most) move = move * (most / std::sqrt(length2));
      p.position[i] += move;
      wrapPlace(w.grid, w.scene.domain, p.position[i]);
    }
  }
  return densityRelaxationIterations;
}

/// Returns the image of x across periodic sides nearest to a body's middle, for bodies that reach across a
/// side.
Vec3d imageIn(const CellGrid& g, const Vec3d& middle, Vec3d x) {
  for (int a = 0; a < 3; a++)
    if (g.periodic[a]) x[a] -= g.period[a] * std::round((x[a] - middle[a]) / g.period[a]);
  return x;
}

}  // namespace

int relaxPacking(World& w, Halos halos, StepTools& t,
                 const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  // By body. Emitted particles belong to no body.
  std::vector<std::uint8_t> relaxed(std::numeric_limits<std::uint16_t>::max() + std::size_t{1}, 0);
  for (std::size_t b = 0; b < w.scene.bodies.size(); b++)
    relaxed[b] = w.scene.bodies[b].packing == Packing::Relaxed;
  if (std::find(relaxed.begin(), relaxed.end(), 1) == relaxed.end()) return 0;
  Continuum& p = w.particles;
  std::vector<Vec3d> middle;
  for (const auto& s : shapes) middle.push_back(0.5 * (s->bounds().min + s->bounds().max));
  const bool everywhere = liquidFillsTheBox(w.scene);  // particles that cross a side then return on the
                                                       // opposite side
  const double dx = w.scene.spacing, V = dx * dx * dx;
  for (int k = 0; k < iterations; k++) {
    kernelGradients(w, halos, t);
    for (std::size_t i = 0; i < p.owned; i++) {
      const std::size_t body = p.body[i];
      if (!relaxed[body]) continue;
      // force / V^2 is -2 sum grad W (1/m^4). Times V dx it is the fraction of a spacing missing on one side.
      Vec3d move = p.force[i] * (0.25 * dx * dx / V);
      const double length2 = dot(move, move), most = 0.1 * dx;
      if (length2 > most * most) move = move * (most / std::sqrt(length2));
      p.position[i] += move;
      if (!everywhere)
        p.position[i] = pullInside(*shapes[body], imageIn(w.grid, middle[body], p.position[i]), 0.45 * dx);
      wrapPlace(w.grid, w.scene.domain, p.position[i]);
    }
  }
  int settling = 0;
  if (w.modules.fluid && !w.modules.continuity && !everywhere)
    settling = relaxDensity(w, halos, t, freeBodies(w, halos, relaxed));
  p.resize(p.owned, 0);
  return iterations + settling;
}

}  // namespace thaw
