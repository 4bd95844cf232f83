#include "io/scene/read_sections.hpp"

namespace thaw {

void readSurface(TableReader& r, SurfaceSettings& s) {
  if (!r.describing()) s.where = r.place();
  for (const char* key : {"spacing", "support", "particle_support", "every_steps", "every_move", "implicit",
                          "attract", "smooth", "repel", "iso_level", "least_level", "damping", "iterations",
                          "stop", "adapt", "keep_volume", "link_length"})
    if (r.has(key)) s.places[key] = r.placeOf(key);
  r.number("spacing", s.spacing, "m", notNegative(),
           "wanted distance of surfels, and the radius of their discs; 0: half the spacing of particles");
  r.number("support", s.support, "", between(1.5, 12),
           "radius within which surfels act on each other (h_ss), over their spacing; the paper's h_ss = h "
           "means hundreds of neighbours on a detailed body");
  r.number("particle_support", s.particleSupport, "", between(1, 3),
           "radius within which particles act on surfels (h_ps), over the support radius of the particles");
  r.choice("source", s.source, {"automatic", "particles"},
           "where the first surfels come from: sampled from the mesh of a body that has one and from the "
           "shape of what begins solid (unless numerics.overlap removes particles), grown from the particles "
           "elsewhere; or always grown from the particles");
  r.whole("every_steps", s.everySteps, 0, INT64_MAX,
          "steps between updates of the surface; 0: as the other rules say. Every frame has an update of its "
          "own");
  r.number("every_move", s.everyMove, "", between(0, 10),
           "update when some particle has moved this share of the support radius since the last one; 0: "
           "never for that");
  r.number("implicit", s.implicit, "", between(0, 1),
           "weight of the force to the iso-surface of the particles' colour field");
  r.number("attract", s.attract, "", between(0, 1), "weight of the force toward the particles");
  r.number("smooth", s.smooth, "", between(0, 1), "weight of the smoothing force");
  r.number("repel", s.repel, "", between(0, 1), "weight of the force that spaces surfels evenly");
  r.choice("smoothing", s.smoothing, {"sphere", "plane"},
           "to where neighbours and their normals lie on a common sphere, which does not shrink curved "
           "surfaces; or to the plane of the neighbours (the paper)");
  r.number("iso_level", s.isoLevel, "", between(0.2, 0.8),
           "of the colour field, for the implicit force; at .5 the surface lies where its particles end");
  r.number("least_level", s.leastLevel, "", between(0.01, 0.9),
           "no surfel is where the colour field is below this: stretched bodies split (I_min)");
  r.number("damping", s.damping, "", {0, 2, true, false, false},
           "factor of every move of the update (alpha)");
  r.whole("iterations", s.iterations, 1, 10000, "of an update, at most");
  r.number("stop", s.stop, "", between(1e-6, 1),
           "surfels that move less than this share of their spacing across the surface and five times it "
           "along it, as do their neighbours, are left alone for the rest of the update");
  r.number("adapt", s.adapt, "", between(0, 1),
           "finest spacing over the wanted one, where the surface is curved: small drops and edges; 0: the "
           "same spacing everywhere");
  r.number("keep_volume", s.keepVolume, "", between(0, 1),
           "weight of a force that keeps the volume in the surface of what is liquid, or was and froze, at "
           "that of the particles, times what the mesh of their body held over it at the start. What never "
           "melted keeps its place. docs/reference/surfaces.md says what to expect. 0: none");
  r.choice(
      "merge", s.merge, {"liquid", "all", "none"},
      "whose surfaces become one where they meet. liquid: of two components of which one at least is liquid "
      "there, when a particle of one is inside the other's surface or they are as near as particles of one "
      "liquid; all: of two solids as well, when a particle of one is inside the other's surface (contact "
      "forces mostly keep it out: solids that are to join need to weld or be pressed together); none: of no "
      "two. Surfaces that meet and do not join are kept apart. Particles feel nothing of it");
  r.number("link_length", s.linkLength, "", between(1.1, 4),
           "spacings between particles over which they hold a component together; near 1 a lattice that is "
           "hardly strained comes apart");
}

}  // namespace thaw
