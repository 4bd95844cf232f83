// SPDX-License-Identifier: Apache-2.0
#include "core/walls/wall_surface_energy.hpp"

#include <algorithm>

#include "core/materials/rest_density.hpp"

namespace thaw {
namespace {

WallColour atWall(const Scene& scene, const CellGrid& grid, const WallContact& c) {
  const double h = grid.support, dx = scene.spacing / h;
  return wallColour(dx, std::max(c.distance / h, -0.5 * dx));
}

}  // namespace

void findSurfaceEnergy(const WallContext& x, const SurfaceMeasure& measure, const WallContacts& contacts) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  for (const WallContact& c : contacts.list) {
    const WallColour t = atWall(w.scene, w.grid, c);
    p.surfaceGradient[c.row] += c.normal * (t.slope * c.share);
    p.surfaceColour[c.row] += t.colour * c.share;
  }
  for (std::size_t i = 0; i < p.owned; i++) {
    const Material& m = w.scene.materials[p.material[i]];
    const double f = p.liquid.active        ? static_cast<double>(p.liquid[i])
                     : p.phase[i] == Liquid ? 1
                                            : 0,
                 tension = f * m.surfaceTension;
    p.surfaceEnergyByGradient[i] = {};
    p.surfaceEnergyByColour[i] = 0;
    if (!(tension > 0)) continue;
    const SurfaceState s = surfaceState(measure, tension, p.surfaceGradient[i], p.surfaceColour[i]);
    p.surfaceEnergyByGradient[i] = s.byGradient;
    p.surfaceEnergyByColour[i] = s.byColour;
    p.interaction[i] += s.energy * p.mass[i] / restDensityOf(p, w.scene.materials, i);
  }
}

double surfaceForceOfWall(const Scene& scene, const CellGrid& grid, const Continuum& p,
                          const WallContact& c) {
  const WallColour t = atWall(scene, grid, c);
  const double V = p.mass[c.row] / restDensityOf(p, scene.materials, c.row);
  return -V * c.share / grid.support *
         (dot(p.surfaceEnergyByGradient[c.row], c.normal) * t.bend +
          p.surfaceEnergyByColour[c.row] * t.slope);
}

}  // namespace thaw
