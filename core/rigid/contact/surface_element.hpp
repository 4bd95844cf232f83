// SPDX-License-Identifier: Apache-2.0
// Surface of a rigid piece at one of its particles: part of an osculating sphere, or of a plane.
#pragma once
#include <limits>
#include <span>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

struct SurfaceElement {
  Vec3f normal{};    ///< outward unit normal. Round elements: vector from the particle to the shape's sharp
                     ///< edge or corner, over the offset; zero: no edge
  float offset = 0;  ///< m, distance of the particle from the surface; 0: inside the piece, no surface
  float radius = 0;  ///< m, radius of curvature at the surface point along the normal. Infinite: plane. Equal
                     ///< to the offset: round, for a corner or a single particle. Negative: code of a sharp
                     ///< edge (edge_code.hpp)
};

inline constexpr float planeRadius = std::numeric_limits<float>::infinity();

/// Largest distance (spacings) along a plane between a particle and a point that its element describes.
inline constexpr double elementReach = 1.0;

/// The same for spheres, as the distance of the point from the line through centre and particle. Elements
/// then leave no holes. On spheres with a radius of two spacings, no surface point is farther than 1.16
/// spacings from its nearest particle, measured in this way.
inline constexpr double sphereReach = 1.2;

/// The same for a plane that a sphere, an edge or a corner touches. Particles at edges are round. Planes thus
/// end up to 1.5 spacings before the edges of their body, and up to 2.2 spacings before its corners.
inline constexpr double planeReach = 2.25;

/// Returns the element of a particle at x (m, in the frame of the shape) in a piece that fills the shape.
SurfaceElement elementOfShape(const SignedDistance& shape, const Vec3d& x, double spacing);

/// Returns the element of a particle from the surrounding particles of its piece, for example if melting has
/// changed the shape. neighbours: positions (m) relative to the particle, at least those within 1.8 spacings.
/// The surface is half a spacing outside of the outermost particles.
SurfaceElement elementOfNeighbours(std::span<const Vec3d> neighbours, double spacing);

}  // namespace thaw
