// SPDX-License-Identifier: Apache-2.0
// Connected components of surfels and particles over all ranks (K05 4.4.1).
//
// Links exist within a previous component:
// - Two surfels with normals within pi/4, one among the k = 10 nearest of the other (S_rest).
//   Their nearest particles must be within 5/3 (liquids: 2) of the particle link length.
//   Without this limit, the skin over a crack or a parting neck would stretch for long.
// - A surfel and its nearest particle. With S_rest only, the faces of a cube would be separate
//   (docs/validation/stability.md, row 19).
// - Two particles closer than settings.linkLength * spacing.
//
// A component splits where no link remains.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/work/topology_tools.hpp"
#include "core/time/clock.hpp"

namespace thaw {

/// Number of nearest neighbours for S_rest.
inline constexpr int nearestSurfels = 10;

/// Labels new particles with the component of the nearest labelled particle within linkLength * spacing,
/// repeatedly. Isolated particles stay unlabelled. Surfels without a component get the component of the
/// nearest particle, preferably of the body in their id. Requires: placed rows with ghosts. Sends components.
/// Collective.
void labelNewParticles(const Scene& scene, Surface& surface, SurfaceHalos halos, ComponentTools& tools);

/// Finds connected parts. Surfels::part and SurfaceParticles::part of owned and ghost rows become 1 + the
/// smallest particle id of the part. Surfels without particles get a number with the top bit set. Requires:
/// placed rows with ghosts. Collective; the number of exchanges grows with the number of ranks that a body
/// crosses, not with its size.
void findParts(const Scene& scene, Surface& surface, SurfaceHalos halos, ComponentTools& tools);

/// Attaches enclosed parts without surfels. Such parts occur because sparse liquids have gaps longer than a
/// link near their surface. If a particle of the part lies inside the surface of its previous component, the
/// part joins the part of the nearest surfel. If there are several, it joins the smallest. In K05, too, a
/// particle belongs to the surface that encloses it. Particles farther than h_ps from every surfel are not
/// tested. Requires: findParts. Collective.
void attachEnclosed(Surface& surface, SurfaceHalos halos, ComponentTools& tools);

/// Makes components from parts. Components with several parts are counted and logged as split, in the
/// order of labels. If the smallest label of a component changes, it is first logged as renamed. Surfels
/// without a particle are deleted and counted as lost. Ghosts of surfels are dropped. Requires: findParts.
/// Collective.
void splitComponents(const Clock& clock, Surface& surface, SurfaceHalos halos, ComponentTools& tools);

}  // namespace thaw
