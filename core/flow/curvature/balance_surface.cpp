// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/balance_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/flow/curvature/surface_loops.hpp"
#include "core/halo/exchange.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {
namespace {

/// Curvatures times the spacing between which the balance sets in. Errors of the curvature push drops of few
/// particles most. Larger drops keep the force of the curvature, which is more accurate.
constexpr double flatBend = 0.3, strongBend = 0.6;

/// (1 - n n) d for a vector a n of any size a.
Vec3d alongSurface(const Vec3d& normal, double area, const Vec3d& d) {
  return d - normal * (dot(normal, d) / (area * area));
}

/// Tension (N/m) of a particle's element. The surface is half a spacing outside of the particles: a ball's is
/// larger than the shell of its outermost particles.
double shellTension(const CurvatureContext& x, std::uint32_t i) {
  const double bend = 0.25 * x.world.particles.surfaceColour[i] * x.world.scene.spacing;
  return tensionAt(x.world, i) / (1 - std::clamp(bend, -0.4, 0.4));
}

/// Force (N) of the surface stress on a row: sum_j A_i A_j gamma (P_i + P_j) grad W, kernel of a plane.
Vec3d stressForce(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l) {
  const Continuum& p = x.world.particles;
  const double h = x.world.grid.support, area = weightOf(p, i), tension = shellTension(x, i);
  Vec3d sum{};
  eachNeighbour(x, i, g, l, [&](std::uint32_t j, const Vec3d& d) {
    const double other = weightOf(p, j), strength = 0.5 * (tension + shellTension(x, j)) * area * other *
                                                    sameFace(p.surfaceGradient[i], p.surfaceGradient[j]) *
                                                    (1 - dot(d, d));
    sum += (alongSurface(p.surfaceGradient[i], area, d) + alongSurface(p.surfaceGradient[j], other, d)) *
           strength;
  });
  return sum * (12 / (std::numbers::pi * h * h * h));
}

/// Returns true if the surface ends near a row, at a wall or a solid, which take up momentum.
bool surfaceEndsNear(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l) {
  for (const WallContact& c : contactsOf(x.contacts, i))
    if (c.distance < x.world.grid.support) return true;
  return hasSolidNeighbour(x, g, l);
}

}  // namespace

void balanceSurface(const CurvatureContext& x, const std::vector<FreeSurfaceElement>& elements,
                    std::vector<Vec3d>& force) {
  Continuum& p = x.world.particles;
  std::vector<Vec3d> excess(p.owned);
  std::vector<double> area(p.owned);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    area[i] = weightOf(p, i);
    const double bend = std::abs(elements[i].curvature) * x.world.scene.spacing;
    if (bend <= flatBend || surfaceEndsNear(x, i, g, l)) return;
    double all = area[i];
    eachNeighbour(x, i, g, l,
                  [&](std::uint32_t j, const Vec3d& d) { all += weightOf(p, j) * (1 - dot(d, d)); });
    excess[i] = (force[i] - stressForce(x, i, g, l)) * (smoothStep(flatBend, strongBend, bend) / all);
  });
  for (std::uint32_t i = 0; i < p.owned; i++) p.surfaceGradient[i] = excess[i];
  refresh(x.halo, p, ColumnList{&p.surfaceGradient}).wait();
  eachRow(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    if (!(area[i] > 0)) return;
    Vec3d sum = p.surfaceGradient[i];
    eachNeighbour(x, i, g, l,
                  [&](std::uint32_t j, const Vec3d& d) { sum += p.surfaceGradient[j] * (1 - dot(d, d)); });
    force[i] -= sum * area[i];
  });
}

}  // namespace thaw
