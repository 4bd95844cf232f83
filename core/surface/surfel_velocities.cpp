// SPDX-License-Identifier: Apache-2.0
#include "core/surface/surfel_velocities.hpp"

#include "core/surface/advection/displace.hpp"
#include "core/surface/advection/gather_particles.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

std::vector<Vec3d> surfelVelocities(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& surface = w.surface;
  SurfaceParticles& p = surface.particles;
  gatherParticles(w, halos.all.rank());
  for (std::size_t i = 0; i < w.particles.owned; i++) {
    p.position[i] = w.particles.position[i];
    p.displacement[i] = w.particles.velocity[i];
  }
  placeRows(surface.grid, halos.surfels, surface.surfels, surface.surfelCells, t.sort);
  placeParticles(surface, halos, t);
  findDisplacementGradients(w.grid, surface, halos, t);
  std::vector<Vec3d> velocities = interpolatedDisplacements(surface, t);
  p.resize(p.owned, 0);
  p.resize(0, 0);
  return velocities;
}

}  // namespace thaw
