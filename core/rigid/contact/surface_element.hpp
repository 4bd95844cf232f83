// SPDX-License-Identifier: Apache-2.0
// Surface of a rigid piece at one of its particles: a part of an osculating sphere, or of a plane.
#pragma once
#include <limits>
#include <span>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

struct SurfaceElement {
  Vec3f normal{};    ///< outward unit normal. Round elements: vector from the particle to the sharp edge or
                     ///< corner of the shape, over the offset; zero: none
  float offset = 0;  ///< m, distance of the particle from the surface; 0: inside the piece, no surface
  float radius = 0;  ///< m, of curvature, through the surface point along the normal; infinite: plane; the
                     ///< offset: a corner or a lone particle, round; negative: code of a sharp edge
                     ///< (edge_code.hpp)
};

inline constexpr float planeRadius = std::numeric_limits<float>::infinity();

/// Largest distance (spacings) along a plane between a particle and a point that its element describes.
inline constexpr double elementReach = 1.0;

/// The same for spheres, as the distance of the point from the line through centre and particle. Elements
/// leave no holes then: on spheres of two spacings, particles are up to 1.16 apart from the surface points
/// that are nearest to none.
inline constexpr double sphereReach = 1.2;

/// The same for a plane that a sphere, an edge or a corner touches. Planes end at up to 1.5 spacings from the
/// edges of their body, where particles are round, and at 2.2 from its corners.
inline constexpr double planeReach = 2.25;

/// Returns the element of a particle at x (m, in the frame of the shape) in a piece that fills the shape.
SurfaceElement elementOfShape(const SignedDistance& shape, const Vec3d& x, double spacing);

/// Returns the element of a particle from the particles of its piece around it, for example where the shape
/// is lost by melting. neighbours: positions (m) relative to it, at least those within 1.8 spacings. The
/// surface is half a spacing outside of the outermost particles.
SurfaceElement elementOfNeighbours(std::span<const Vec3d> neighbours, double spacing);

}  // namespace thaw
