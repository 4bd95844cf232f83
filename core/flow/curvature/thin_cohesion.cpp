// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/thin_cohesion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/flow/curvature/surface_loops.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/halo/exchange.hpp"
#include "core/materials/rest_density.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

/// The force factor is phi = q (1 - q)^2 (q - a), repulsive below q = a. Its moment is int_0^1 q^4 phi dq
/// (TP16 eq. 14).
constexpr double repulsiveBelow = 0.4, moment = 1.0 / 252 - repulsiveBelow / 168;
double cohesionAt(double q) { return q * (1 - q) * (1 - q) * (q - repulsiveBelow); }

/// Returns the tension of a film, relative to a film with gas on both sides. A wall covers one face, which
/// leaves gamma (1 - cos(theta)) of 2 gamma. The reduction applies only to pairs of particles that are both
/// on a wall. Liquid above them has full cohesion with them, and spreads on them as on liquid.
double uncovered(const CurvatureContext& x, std::uint32_t row) {
  double least = 1;
  for (const WallContact& c : contactsOf(x.contacts, row))
    least = std::min(least, 1 - shareOfWall(x, c) * 0.5 * (1 + wettingAt(x.world, c)));
  return least;
}

/// Packs the data of pairs into surfaceGradient: x: 1 - resolved; y: uncovered; z: V sqrt(gamma) times the
/// liquid fraction.
void packCohesion(const CurvatureContext& x, const std::vector<FreeSurfaceElement>& elements) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  for (std::uint32_t i = 0; i < p.owned; i++) {
    const double f = p.phase[i] == Liquid ? liquidFraction(p, i) : 0;
    p.surfaceGradient[i] = {};
    if (f == 0) continue;
    p.surfaceGradient[i] = {1 - elements[i].resolved, uncovered(x, i),
                            restVolumeOf(p, w.scene.materials, i) * std::sqrt(tensionAt(w, i)) * f};
  }
}

}  // namespace

void addThinCohesion(const CurvatureContext& x, const std::vector<FreeSurfaceElement>& elements,
                     std::vector<Vec3d>& force) {
  Continuum& p = x.world.particles;
  const NeighbourLists& lists = x.neighbours;
  const double h = x.world.grid.support, h2 = h * h, scale = 8 / (std::numbers::pi * moment) / (h2 * h2 * h);
  packCohesion(x, elements);
  refresh(x.halo, p, ColumnList{&p.surfaceGradient}).wait();
  const auto isThin = [&](std::size_t i) { return p.surfaceGradient[i].x > 0; };
  std::size_t first = 0;
  while (first < p.size() && !isThin(first)) first++;
  if (first == p.size()) return;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8 && lists.fluid[g]; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy || !(p.surfaceGradient[i].z > 0)) continue;
      const Vec3d own = p.surfaceGradient[i], at = p.position[i];
      Vec3d sum{};
      for (std::uint32_t k = 0; k < lists.count[g]; k++) {
        const std::uint32_t j = lists.row(g, k, l);
        if (j == lists.dummy) continue;
        const Vec3d& other = p.surfaceGradient[j];
        const double thin = std::max(own.x, other.x);
        if (!(thin * other.z > 0)) continue;
        const Vec3d d = p.position[j] - at;
        const double q = length(d) / h;
        if (q < 1 && q > 1e-6)
          sum += d * (thin * std::max(own.y, other.y) * other.z * cohesionAt(q) / (q * h));
      }
      force[i] += sum * (own.z * scale);
    }
}

}  // namespace thaw
