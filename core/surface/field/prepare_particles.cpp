// SPDX-License-Identifier: Apache-2.0
#include "core/surface/field/prepare_particles.hpp"

#include <cstring>
#include <numbers>
#include <vector>

#include "core/surface/data/place_rows.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

/// Factors that normalise the colour, a sum of (1 - (r/h)^2)^3, to 1 inside a lattice with spacing 1.
struct Lattice {
  double perSum = 0;     ///< inverse of the sum over the cubic lattice, for sums at arbitrary positions
  double perOwnSum = 0;  ///< the same for sums at particles
  /// Weight of a particle in its own sum. It represents a ball, not a point, so the surface of a single
  /// particle encloses its volume.
  double self = 1;
};
Lattice latticeOf(double h, const LevelTable& table) {
  double sum = 0;
  const int n = static_cast<int>(h);
  for (int z = -n; z <= n; z++)
    for (int y = -n; y <= n; y++)
      for (int x = -n; x <= n; x++) {
        const double u = 1 - (x * x + y * y + z * z) / (h * h);
        if (u > 0) sum += u * u * u;
      }
  // A single particle has colours c = x, a = x^2 and fullness b / a = x = self / (sum - 1 + self). Around it,
  // the colour is c u^3 / sum. At the surface of its volume, the colour must equal the level.
  const double R = std::cbrt(3 / (4 * std::numbers::pi)), u = 1 - R * R / (h * h), wanted = u * u * u / sum;
  double low = 0, high = 1 / sum;
  for (int k = 0; k < 60; k++) {
    const double x = 0.5 * (low + high);
    (table.level(x) < wanted * x ? low : high) = x;
  }
  Lattice l;
  l.self = low * (sum - 1) / (1 - low);
  l.perSum = 1 / sum;
  l.perOwnSum = 1 / (sum - 1 + l.self);
  return l;
}

/// Returns the volume (m^3) of each particle in the colour field, ghosts included. The weight of a lattice
/// particle includes the body's fraction of its cell, so balls have no steps.
std::vector<double> weightsOf(const SurfaceParticles& p) {
  std::vector<double> weight(p.volume.data(), p.volume.data() + p.size());
  if (p.fill.active)
    for (std::size_t j = 0; j < weight.size(); j++)
      if (p.fill[j] > 0) weight[j] *= static_cast<double>(p.fill[j]);
  return weight;
}

}  // namespace

void placeParticles(Surface& s, SurfaceHalos halos, SurfaceTools& t) {
  placeRows(s.grid, halos.particles, s.particles, s.particleCells, t.sort);
  t.relax.particlesPrepared = false;
}

void prepareParticles(const Scene& scene, Surface& s, SurfaceHalos halos, SurfaceTools& t) {
  if (t.relax.particlesPrepared) return;
  t.relax.particlesPrepared = true;
  if (!t.relax.level.filled()) t.relax.level.fill();
  SurfaceParticles& p = s.particles;
  p.resize(p.owned, 0);
  ColumnList columns{&p.id, &p.position, &p.component, &p.volume, &p.volumeRatio, &p.body};
  if (p.fill.active) columns.push_back(&p.fill);
  if (p.liquid.active) columns.push_back(&p.liquid);
  if (p.temperature.active) columns.push_back(&p.temperature);
  addGhosts(halos.particles, p, s.particleCells, columns);
  const double h = s.particleSupport, h2 = h * h, dx = scene.spacing, perVolume = 1 / (dx * dx * dx);
  const Lattice lattice = latticeOf(h / dx, t.relax.level);
  fillBins(s.grid, s.particleCells, p.position.data(), 0.5 * h, t.relax.particleBins);
  const std::vector<double> weight = weightsOf(p);
  // First pass: colour at each particle. Second pass: particles weighted by their colour.
  for (int pass = 0; pass < 2; pass++) {
    Column<float>& to = pass == 0 ? p.colour : p.smoothColour;
    RowBlock block;
    forBlocks(t.relax.particleBins, t.relax.particleBins, h, block, [&](std::uint32_t i, RowBlock& around) {
      if (i >= p.owned) return;
      double sum = 0;
      const Vec3d x = p.position[i];
      if (p.component[i] != noComponent)
        for (const std::uint32_t k : around.around(x, h)) {
          const std::uint32_t j = around.row[k];
          const Vec3d d = around.at[k] - x;
          const double u = 1 - dot(d, d) / h2;
          if (u > 0 && p.component[j] == p.component[i])
            sum += weight[j] * (j == i ? lattice.self : u * u * u) *
                   (pass == 0 ? 1.0 : static_cast<double>(p.colour[j]));
        }
      to[i] = static_cast<float>(perVolume * lattice.perOwnSum * sum);
    });
    ColumnList found{&to};
    refreshGhosts(halos.particles, p, found);
  }
  // packed data for the iterations
  t.relax.particle.resize(4 * p.size());
  t.relax.particleColour.resize(p.size());
  for (std::size_t j = 0; j < p.size(); j++) {
    for (int a = 0; a < 3; a++) {
      const std::uint32_t bits = fixedPoint(s.grid, p.position[j][a], a);
      std::memcpy(&t.relax.particle[4 * j + static_cast<std::size_t>(a)], &bits, 4);
    }
    const float volume = static_cast<float>(perVolume * lattice.perSum * weight[j]);
    t.relax.particle[4 * j + 3] = volume * p.colour[j];
    t.relax.particleColour[j] = volume * p.smoothColour[j];
  }
}

void sampleFields(const Scene& scene, Surface& surface, SurfaceHalos halos, SurfaceTools& t) {
  prepareParticles(scene, surface, halos, t);
  Surfels& s = surface.surfels;
  const SurfaceParticles& p = surface.particles;
  if (!s.liquid.active && !s.temperature.active) return;
  const double h = surface.particleSupport, h2 = h * h;
  for (std::size_t i = 0; i < s.owned; i++) {
    double weights = 0, liquid = 0, temperature = 0;
    forRowsAround(t.relax.particleBins, s.position[i], s.position[i], h,
                  [&](std::uint32_t j, const Vec3d& at) {
                    const Vec3d d = at - s.position[i];
                    const double u = 1 - dot(d, d) / h2;
                    if (!(u > 0) || p.component[j] != s.component[i]) return;
                    const double v = u * u * u;
                    weights += v;
                    if (s.liquid.active) liquid += v * static_cast<double>(p.liquid[j]);
                    if (s.temperature.active) temperature += v * static_cast<double>(p.temperature[j]);
                  });
    if (!(weights > 0)) continue;
    if (s.liquid.active) s.liquid[i] = static_cast<float>(liquid / weights);
    if (s.temperature.active) s.temperature[i] = static_cast<float>(temperature / weights);
  }
}

}  // namespace thaw
