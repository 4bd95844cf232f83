// SPDX-License-Identifier: Apache-2.0
// The surface of a frame as triangles, for the page.
#pragma once
#include <vector>

#include "io/surface_mesh/mesh_detail.hpp"
#include "io/view/frames/frame_packet.hpp"

namespace thaw {

/// A surface as read from its frame.
struct SurfaceToMesh {
  SurfaceFrame surfels;
  std::vector<std::uint32_t> drawn;  ///< rows of framePacket, in its order
  std::uint64_t most = 0;            ///< as in FrameRequest
};

/// Reads a surface. request: the field is ignored. Throws IoError.
SurfaceToMesh readSurfaceToMesh(const FrameRequest& request);

/// Returns the detail of meshes for the page. Cubes are at least as wide as the radius of a surfel. They are
/// wide enough that the mesh has about `most` vertices, at most 50,000. Meshing then takes well under a
/// second.
MeshDetail detailForPage(std::size_t surfels, std::uint64_t most);

/// Returns closed meshes of all components: `position`, `normal`, `triangles`, and `surfel`. For each vertex,
/// `surfel` is the nearest point of framePacket, whose fields it shows. Reads no file.
Packet meshPacket(const SurfaceToMesh& surface, const PeriodicSides& sides);

}  // namespace thaw
