// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_sections.hpp"

namespace thaw {

void readSurface(TableReader& r, SurfaceSettings& s) {
  s.on = s.on || r.reading();
  r.locate(s.where);
  r.restart(Restart::Setting);
  if (r.reading()) s.places = r.placesOfKeys();
  r.number("spacing", s.spacing, "m", notNegative(),
           "surfel spacing, and radius of the discs; 0: half the particle spacing");
  r.number("support", s.support, "", between(1.5, 12),
           "radius within which surfels act on each other (h_ss), in surfel spacings; with h_ss = h, as in "
           "Keiser et al. 2005, a surfel on a detailed body has hundreds of neighbours");
  r.number(
      "particle_support", s.particleSupport, "", between(1, 3),
      "radius within which particles act on surfels (h_ps), as a multiple of the particles' support radius");
  r.as(Restart::Start)
      .choice("source", s.source, {"automatic", "particles"},
              "source of the first surfels. automatic: sampled from the meshes of bodies and the shapes of "
              "initially solid bodies, unless `numerics.overlap` removes particles; else grown from the "
              "particles. particles: always grown from the particles");
  r.whole("every_steps", s.everySteps, 0, INT64_MAX,
          "steps between updates of the surface; 0: only by `every_move`. Each frame has its own update");
  r.number("every_move", s.everyMove, "", between(0, 10),
           "update when a particle has moved this fraction of the support radius since the last one; 0: no "
           "such updates");
  r.number("implicit", s.implicit, "", between(0, 1),
           "weight of the force to the iso-surface of the particles' colour field");
  r.number("attract", s.attract, "", between(0, 1), "weight of the force toward the particles");
  r.number("smooth", s.smooth, "", between(0, 1), "weight of the smoothing force");
  r.number("repel", s.repel, "", between(0, 1), "weight of the force that spaces surfels evenly");
  r.choice("smoothing", s.smoothing, {"sphere", "plane"},
           "sphere: toward a common sphere of the neighbours and their normals, which does not shrink curved "
           "surfaces. plane: toward the plane of the neighbours (Keiser et al. 2005)");
  r.number("iso_level", s.isoLevel, "", between(0.2, 0.8),
           "level of the colour field for the implicit force; at 0.5 the surface lies at the boundary of the "
           "particles");
  r.number("least_level", s.leastLevel, "", between(0.01, 0.9),
           "lowest colour field at a surfel; below it stretched bodies split (I_min)");
  r.number("damping", s.damping, "", {0, 2, true, false, false},
           "factor of each displacement in an update (alpha)");
  r.whole("iterations", s.iterations, 1, 10000, "largest number of iterations per update");
  r.number("stop", s.stop, "", between(1e-6, 1),
           "a surfel stops if it moves by less than this fraction of its spacing across the surface, and "
           "less than five times this along it. Surfels that stop, like their neighbours, are skipped for "
           "the rest of the update");
  r.number("adapt", s.adapt, "", between(0, 1),
           "finest spacing as a fraction of `spacing`, where the surface is curved: at small drops and "
           "edges; 0: the same spacing everywhere");
  r.number(
      "enforce_volume", s.enforceVolume, "", between(0, 1),
      "weight of a force that keeps the volume inside a surface. Its target is the volume of the particles, "
      "times the ratio of mesh to particle volume at the start. It acts on liquid, and on solid that was "
      "liquid. Surfaces that never melted keep their position. See docs/reference/surfaces.md. 0: none");
  r.choice("merge", s.merge, {"liquid", "all", "none"},
           "surfaces that merge on contact. liquid: those of two components, at least one of them liquid "
           "there. They merge if a particle of one lies inside the other's surface, or if they are as close "
           "as particles of one liquid. all: also two solids, if a particle of one lies inside the other's "
           "surface; contact forces mostly prevent this, so solids must weld or be pressed together. none: "
           "no surfaces merge. Surfaces that do not merge are kept apart. Particles are not affected");
  r.number("link_length", s.linkLength, "", between(1.1, 4),
           "largest distance (spacings) of particles that connect a component; near 1 a hardly strained "
           "lattice falls apart");
}

}  // namespace thaw
