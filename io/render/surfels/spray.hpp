// SPDX-License-Identifier: Apache-2.0
// Drops of one and two particles in pictures of a surface.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/frames/read_surface_frame.hpp"

namespace thaw {

/// Throws std::invalid_argument for other names than ellipsoids, spheres, hide and surfels.
Spray sprayNamed(const std::string& name);

struct SprayStyle {
  Spray look = Spray::Surfels;
  double spacing = 0;   ///< m, of the particles; 0: unknown, and no component is a drop
  double exposure = 0;  ///< s, time of motion that stretches drops
};

/// A component of at most two particles, estimated from the volume of the ball through its surfels.
struct SprayDrop {
  std::uint64_t component = 0;
  std::vector<std::uint32_t> rows;
  Vec3d centre{}, velocity{};  ///< m; m/s
  double radius = 0;           ///< m, mean distance of its surfels from the centre
  double least = 0;            ///< m^3, least volume: that of the particle with its label
};

/// Returns the drops of a frame, ascending by component, with the velocities of their surfels if it has them.
/// Their least volume is the cube of the spacing. Requires: components are unwrapped.
std::vector<SprayDrop> findSpray(const SurfaceFrame& frame, double spacing);

/// Returns the radius of the ball of a drop's volume, in m. It is at least that of one particle, since a ball
/// that a wall flattens has surfels closer to its centre.
double radiusOf(const SprayDrop& drop);

/// Returns the ratio of an ellipsoid's long half axis to the radius of the ball of its volume. It ranges from
/// 1 at rest to 2 for fast drops. It is 1.5 where a drop moves by its diameter in the exposure.
double stretchOf(const SprayDrop& drop, double exposure);

/// Replaces the surfels of drops by new ones. They have the colours, fields and ids of the drop's first one.
void replaceSpray(SurfaceFrame& frame, const std::vector<SprayDrop>& drops, const SprayStyle& style);

}  // namespace thaw
