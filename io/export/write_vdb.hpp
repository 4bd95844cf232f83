// SPDX-License-Identifier: Apache-2.0
// OpenVDB grids of a frame. The library is optional at configure time.
#pragma once
#include <filesystem>

#include "io/export/export_scene.hpp"

namespace thaw {

/// Writes grids in metres with voxels of the particle spacing (half of it for the surface):
/// - surface: level set of the surface, in the scene's place, negative inside
/// - density: fog of the particles, 1 in their bulk
/// - temperature (K), liquid (1): means of the particles near each voxel of that fog
/// - velocity (m/s): the same for vectors, for motion blur
/// Throws IoError if the file cannot be written; std::invalid_argument if the program is built without
/// OpenVDB.
void writeVdb(const std::filesystem::path& file, const ExportScene& scene);

}  // namespace thaw
