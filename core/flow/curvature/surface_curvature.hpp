// SPDX-License-Identifier: Apache-2.0
// Normal and curvature of the free surface of liquids (docs/theory/surface_tension.md).
//
// Normals follow from the colour gradient, averaged over neighbours at the surface. Derivatives along the
// surface are least-squares fits in the tangent plane over these neighbours. They are exact for linear
// fields, even at the edge of a surface. Near walls, the normal follows from the contact angle (BPKH13,
// HKEW16).
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/walls/wall_view.hpp"

namespace thaw {

struct CurvatureContext {
  WallView world;
  const NeighbourLists& neighbours;
  const WallContacts& contacts;
  CellHalo& halo;
  Reducer& all;
};

/// Returns the surface tension (N/m) of the liquid of a row, owned or ghost.
double tensionAt(const WallView& world, std::uint32_t row);

/// Size of the colour gradient (h grad C) in the outermost layer of a flat lattice.
double flatColourGradient(const Numerics& numerics);

/// A particle's part of the free surface.
struct FreeSurfaceElement {
  double area = 0;          ///< m^2; 0: not at the surface
  double resolved = 1;      ///< 1: thick liquid; 0: a film, thread or drop without a particle inside
  double curvature = 0;     ///< 1/m, positive for a ball, at half a spacing outside of the particle's centre
  double bulge = never;     ///< 1/m, curvature from positions; `never`: close to a wall, or unknown
  Vec3d normal{};           ///< unit vector out of the liquid
  Vec3d tensionGradient{};  ///< N/m^2, along the surface
};

/// Returns the surface elements of owned rows. Collective.
/// Requires: surfaceGradient and surfaceColour of owned rows without walls, temperatures of ghosts.
/// Ensures: surfaceGradient is the normal times the resolved part of the area, and surfaceColour is the
/// curvature (1/m) before smoothing. Both are also set for ghosts, and are 0 inside.
std::vector<FreeSurfaceElement> findFreeSurface(const CurvatureContext& context);

}  // namespace thaw
