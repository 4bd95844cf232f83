// Frames of the surface, beside those of the particles: NAME_surface_000120.hdf, with an index of their own,
// NAME_surface.hdf.series.
#pragma once
#include "io/output/frame_fields.hpp"

namespace thaw {

/// The name under which a scene's surface frames are numbered and indexed.
std::string surfaceName(const std::string& scene);

/// The owned surfels: position, id, normal, radius, color, component, detail; liquid and temperature where
/// the scene has them. In single precision. "color" is what ParaView and VTK call it: red, green, blue.
Frame surfaceFrameOf(const World& world);

/// Of a file that is a frame: are its points surfels?
bool isSurfaceFrame(const H5File& file);

}  // namespace thaw
