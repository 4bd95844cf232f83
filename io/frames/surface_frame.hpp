// SPDX-License-Identifier: Apache-2.0
// Frames of the surface, beside those of the particles: NAME_surface_000120.hdf, with their own index
// NAME_surface.hdf.series.
#pragma once
#include "io/frames/frame_fields.hpp"

namespace thaw {

/// Returns the name of the frames and the index of the surface.
std::string surfaceName(const std::string& scene);

/// Returns a frame of the owned surfels: position, id, normal, radius, color, component, detail. Also liquid
/// and temperature if the scene has them. In single precision. ParaView and VTK expect the name "color" for
/// red, green, blue. velocities: m/s, one per surfel, added as `velocity`; or none.
Frame surfaceFrameOf(const Surface& surface, const Clock& clock, const std::vector<Vec3d>& velocities = {});

/// Returns whether frames of the scene have velocities of surfels (`surface_velocity` in output.fields).
bool wantsSurfelVelocities(const Scene& scene);

/// Returns whether the points of a frame are surfels.
bool isSurfaceFrame(const H5File& file);

}  // namespace thaw
