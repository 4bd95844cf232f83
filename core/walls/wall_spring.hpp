// SPDX-License-Identifier: Apache-2.0
// Spring between a particle and a wall.
#pragma once
#include <cstddef>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/materials/rest_density.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// A spring that acts on solids within half a spacing, and on liquids, which pressure supports, within a
/// quarter. There is none unless gap and stiffness are positive.
struct WallSpring {
  double rest = 0.5;     ///< spacings at which a solid rests
  double filled = 1;     ///< mass over that of a full particle: the frequency stays as a particle evaporates
  double liquid = 0;     ///< Pa, stiffness of the liquid. 0 with the incompressible solver, which stops
                         ///< liquids itself (stopAtWalls): this spring is too stiff for its steps
  double gap = 0;        ///< m
  double stiffness = 0;  ///< N/m

  double energy() const { return gap > 0 && stiffness > 0 ? 0.5 * stiffness * gap * gap : 0; }
};

inline WallSpring wallSpringOf(const WallContext& x, const WallContact& c) {
  const Scene& scene = x.world.scene;
  const Continuum& p = x.world.particles;
  const double dx = scene.spacing, f = liquidFraction(p, c.row);
  WallSpring s;
  if (p.contactOffset.active) s.rest = static_cast<double>(p.contactOffset[c.row]);
  s.gap = dx * (s.rest + f * (0.25 - s.rest)) - c.distance;
  if (s.gap <= 0) return s;
  if (!x.world.modules.incompressible) s.liquid = x.liquids[p.material[c.row]].stiffness;
  if (x.world.modules.evaporation)
    s.filled = p.mass[c.row] / (restDensityOf(p, scene.materials, c.row) * dx * dx * dx);
  s.stiffness = (scene.materials[p.material[c.row]].young.at(f) + f * s.liquid) * dx * s.filled;
  return s;
}

}  // namespace thaw
