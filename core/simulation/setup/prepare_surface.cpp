// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/prepare_surface.hpp"

#include <algorithm>

#include "core/simulation/setup/make_grid.hpp"
#include "core/surface/seeding/resurface_exposed.hpp"

namespace thaw {

void prepareSurface(World& w) {
  const SurfaceSettings& set = w.scene.surface;
  Surface& s = w.surface;
  s.spacing = surfelSpacing(w.scene);
  s.surfelSupport = set.support * s.spacing;
  s.particleSupport = set.particleSupport * w.grid.support;
  // Neighbourhoods of owned particles and surfels must lie in the adjacent cells. The search for exposed
  // particles needs up to three spacings and a disc. Within a round of iterations, a surfel may move by half
  // a particle spacing before the next sort.
  s.grid = makeGrid(w.scene.domain,
                    std::max(s.surfelSupport + listMargin(s, w.scene.spacing),
                             std::max({s.surfelSupport, s.particleSupport, 3 * s.spacing,
                                       set.linkLength * w.scene.spacing, detachedReach * w.scene.spacing}) +
                                 0.5 * w.scene.spacing));
}

void activateSurfaceFields(Surface& s, const Modules& m, bool walls) {
  Surfels& f = s.surfels;
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&f.id,
                                                        &f.position,
                                                        &f.normal,
                                                        &f.tangent,
                                                        &f.radius,
                                                        &f.component,
                                                        &f.colour,
                                                        &f.detail,
                                                        &f.resampleMargin,
                                                        &f.cell,
                                                        &f.nextCell,
                                                        &f.linkRadius2,
                                                        &f.nearest,
                                                        &f.toNearest,
                                                        &f.part,
                                                        &f.area,
                                                        &f.facets,
                                                        &f.bulge,
                                                        &f.rim,
                                                        &f.targetRadius,
                                                        &f.resampleFlags,
                                                        &f.candidateOffset,
                                                        &f.candidateNormal})
    f.activate(*c);
  SurfaceParticles& p = s.particles;
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{
           &p.id, &p.position, &p.displacement, &p.component, &p.volume, &p.volumeRatio, &p.mass, &p.body,
           &p.source, &p.cell, &p.nextCell, &p.gradient, &p.colour, &p.smoothColour, &p.part})
    p.activate(*c);
  // Otherwise the surface only moves with its particles.
  if (m.melting || m.fluid) {
    f.activate(f.liquid);
    p.activate(p.liquid);
    if (m.solid) f.activate(f.maxLiquidFraction), f.activate(f.detailHeight);
  }
  if (m.solid) {
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.covered, &p.referencePosition}) p.activate(*c);
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&f.hasReference, &f.referencePosition,
                                                          &f.referenceNormal, &f.referenceTangent})
      f.activate(*c);
  }
  if (walls) {
    f.activate(f.wallOffset);
    f.activate(f.onWall);
  }
  if (m.heat) {
    f.activate(f.temperature);
    p.activate(p.temperature);
  }
}

}  // namespace thaw
