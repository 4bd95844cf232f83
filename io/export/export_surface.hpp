// SPDX-License-Identifier: Apache-2.0
// Export of a surface frame to the formats of other programs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/render/particles/render.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

/// All functions throw IoError if the file cannot be written. colours: one per surfel.

/// Writes binary PLY with each surfel as a polygon of `corners` corners, for Blender. Colours are on corners
/// and faces, which Blender keeps, unlike normals of single vertices. `discs`: drawn radius, as a multiple of
/// the surfel's.
void writePlyDiscs(const std::filesystem::path& file, const SurfaceFrame& frame,
                   const std::vector<Rgb>& colours, double discs = 1, int corners = 8);

/// Writes VTK XML PolyData: points with all fields, for ParaView.
void writeVtp(const std::filesystem::path& file, const SurfaceFrame& frame, const std::vector<Rgb>& colours);

/// Writes the same for a frame with triangles (sheets, or triangulated oriented particles): points with all
/// fields, triangles, and lines (of curves).
void writeTrianglesVtp(const std::filesystem::path& file, const FrameData& frame,
                       const std::vector<std::array<std::uint32_t, 2>>& lines = {});

/// Writes the triangles of meshes with normals, colours, and all fields that one of them has
/// (mesh_fields.hpp). Also writes the index of the mesh as "object", and the label of its component (-1:
/// none). time: s.
void writeMeshVtp(const std::filesystem::path& file, double time, const std::vector<ComponentMesh>& meshes);

/// Writes a scene for POV-Ray 3.7: discs, camera, sun, sky, and floors. Lengths are scaled to a stage ten
/// units across.
void writePov(const std::filesystem::path& file, const SurfaceFrame& frame, const std::vector<Rgb>& colours,
              const RenderStyle& style, double discs = 1);

/// Write the closed meshes of components to one file, with normals and colours at the vertices. PLY is
/// binary. Each face has the index of its component in the list (0, 1, ...). Vertices have this index as
/// "object", and all fields that one of the meshes has (mesh_fields.hpp). Ids are split into halves (id_high,
/// id_low), since PLY has no 64-bit type. Lines are edges. OBJ has one object per mesh, called after its name
/// or body, else `component_LABEL`. Lines are `l`. The comment line of a mesh that is cut at periodic sides
/// ends with cutNote (", which extends through ..."). cutNote is empty for other meshes.
void writeMeshPly(const std::filesystem::path& file, const std::vector<ComponentMesh>& meshes);
void writeMeshObj(const std::filesystem::path& file, const std::vector<ComponentMesh>& meshes);
std::string cutNote(const ComponentMesh& mesh);

}  // namespace thaw
