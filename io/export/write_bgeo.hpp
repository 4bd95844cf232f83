// SPDX-License-Identifier: Apache-2.0
// Houdini geometry, classic binary format (version 5).
#pragma once
#include <filesystem>

#include "io/export/export_scene.hpp"

namespace thaw {

/// Writes all meshes of a scene as closed polygons, and its particles as points after their vertices. Point
/// attributes: N; v (m/s); Cd (sRGB, 0 to 1); pscale (m, radius; 0 for vertices); id (the lower 31 bits, -1
/// without one). Also temperature (K); liquid; component (index of the mesh, -1 for particles). The corners
/// of polygons have uv if a mesh has texture coordinates. Big-endian. Throws IoError if the file cannot be
/// written.
void writeBgeo(const std::filesystem::path& file, const ExportScene& scene);

}  // namespace thaw
