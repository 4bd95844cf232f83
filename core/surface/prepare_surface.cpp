#include "core/surface/prepare_surface.hpp"

#include <algorithm>

#include "core/setup/make_grid.hpp"
#include "core/surface/cover_bare.hpp"

namespace thaw {

void prepareSurface(World& w) {
  const SurfaceSettings& set = w.scene.surface;
  Surface& s = w.surface;
  s.spacing = surfelSpacing(w.scene);
  s.surfelSupport = set.support * s.spacing;
  s.particleSupport = set.particleSupport * w.grid.support;
  // what is looked at around a particle or surfel of this rank is in the cells around its own: up to three
  // spacings and a disc in the search for what is bare, too; and a surfel may stray within a round of
  // iterations before all is sorted anew: half a spacing of the particles
  s.grid = makeGrid(w.scene.domain,
                    std::max(s.surfelSupport + listMargin(s, w.scene.spacing),
                             std::max({s.surfelSupport, s.particleSupport, 3 * s.spacing,
                                       set.linkLength * w.scene.spacing, ragReach * w.scene.spacing}) +
                                 0.5 * w.scene.spacing));
}

void activateSurfaceFields(Surface& s, const Modules& m, bool walls) {
  Surfels& f = s.surfels;
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{
           &f.id,      &f.position,  &f.normal, &f.tangent, &f.radius,     &f.component,
           &f.colour,  &f.detail,    &f.calm,   &f.cell,    &f.nextCell,   &f.reach,
           &f.nearest, &f.toNearest, &f.part,   &f.area,    &f.facets,     &f.bulge,
           &f.rim,     &f.wanted,    &f.wish,   &f.offer,   &f.offerNormal})
    f.activate(*c);
  SurfaceParticles& p = s.particles;
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{
           &p.id, &p.position, &p.displacement, &p.component, &p.volume, &p.share, &p.mass, &p.body, &p.home,
           &p.cell, &p.nextCell, &p.gradient, &p.colour, &p.smoothColour, &p.part})
    p.activate(*c);
  if (m.melting || m.fluid) {  // else the surface is carried along and nothing more
    f.activate(f.liquid);
    p.activate(p.liquid);
    if (m.solid) f.activate(f.softened), f.activate(f.mark);
  }
  if (m.solid) {
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.covered, &p.startPlace}) p.activate(*c);
    for (AnyColumn* c :
         std::initializer_list<AnyColumn*>{&f.follows, &f.startPlace, &f.startNormal, &f.startTangent})
      f.activate(*c);
  }
  if (walls) {
    f.activate(f.pressed);
    f.activate(f.onWall);
  }
  if (m.heat) {
    f.activate(f.temperature);
    p.activate(p.temperature);
  }
}

}  // namespace thaw
