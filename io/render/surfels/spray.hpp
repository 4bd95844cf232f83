// SPDX-License-Identifier: Apache-2.0
// Drops of one and two particles in pictures of a surface.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/frames/read_surface_frame.hpp"

namespace thaw {

/// Look of drops: their own surfels, balls, ellipsoids along their motion, or nothing.
enum class Spray { Surfels, Spheres, Ellipsoids, Hide };

/// Throws std::invalid_argument for other names than ellipsoids, spheres, hide and surfels.
Spray sprayNamed(const std::string& name);

struct SprayStyle {
  Spray look = Spray::Surfels;
  double spacing = 0;   ///< m, of the particles; 0: unknown, and no component is a drop
  double exposure = 0;  ///< s, time of motion that stretches drops
};

/// A component of at most two particles, judged by the volume of the ball through its surfels.
struct SprayDrop {
  std::uint64_t component = 0;
  std::vector<std::uint32_t> rows;
  Vec3d centre{}, velocity{};  ///< m; m/s
  double radius = 0;           ///< m, of the ball of its volume
};

/// Returns the drops of a frame, ascending by component, with the velocities of their surfels if it has them.
/// A drop has at least the volume of one particle. Requires: components are unwrapped.
std::vector<SprayDrop> findSpray(const SurfaceFrame& frame, double spacing);

/// Returns the ratio of an ellipsoid's long half axis to the radius of the ball of its volume: from 1 at rest
/// to 2 for fast drops. Half of the value is reached where a drop moves by its diameter in the exposure.
double stretchOf(const SprayDrop& drop, double exposure);

/// Replaces the surfels of drops by new ones. They have the colours, fields and ids of the drop's first one.
void replaceSpray(SurfaceFrame& frame, const std::vector<SprayDrop>& drops, const SprayStyle& style);

}  // namespace thaw
