// SPDX-License-Identifier: Apache-2.0
// OpenVDB grids of a frame. The library is optional at configure time.
#pragma once
#include <filesystem>

#include "io/export/export_scene.hpp"

namespace thaw {

/// Writes grids in metres. Voxels have the particle spacing, or half of it for the surface:
/// - surface: level set of the surface, in scene coordinates, negative inside
/// - density: fog volume of the particles, 1 in their bulk
/// - temperature (K), liquid (1): means over the particles near each voxel of the fog volume
/// - velocity (m/s): the same, for motion blur
/// - points: the particles themselves, with the attributes P, v (m/s), temperature (K), liquid, id, and
///   pscale (radius, m) if radii differ
///
/// Throws IoError if the file cannot be written; std::invalid_argument if the program is built without
/// OpenVDB.
void writeVdb(const std::filesystem::path& file, const ExportScene& scene);

}  // namespace thaw
