// A frame of a surface as files that other programs read.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/export/surface_mesh.hpp"
#include "io/render/render.hpp"

namespace thaw {

/// Throw IoError where the file cannot be written. colours: one a surfel.

/// PLY, binary: each surfel a polygon of `corners` corners with the colour on its corners and its face, for
/// Blender, which keeps colours of faces and corners but no normals of lone vertices. `discs`: radius over
/// the surfel's.
void writePlyDiscs(const std::filesystem::path& file, const SurfaceFrame& frame,
                   const std::vector<Rgb>& colours, double discs = 1, int corners = 8);

/// VTK's XML PolyData: points with all their fields, for ParaView.
void writeVtp(const std::filesystem::path& file, const SurfaceFrame& frame, const std::vector<Rgb>& colours);

/// The same of a frame with triangles (sheets, or triangulated oriented particles): points with all fields,
/// the triangles, and lines (of curves).
void writeTrianglesVtp(const std::filesystem::path& file, const FrameData& frame,
                       const std::vector<std::array<std::uint32_t, 2>>& lines = {});

/// A scene of POV-Ray 3.7: discs, camera, sun, sky, and floors. Lengths are scaled so that the stage is ten
/// units across.
void writePov(const std::filesystem::path& file, const SurfaceFrame& frame, const std::vector<Rgb>& colours,
              const RenderStyle& style, double discs = 1);

/// The closed meshes of components in one file, with normals and colours at the vertices. PLY: binary, each
/// face with the number of its component in the list (0, 1, ...), with lines as edges and, where there are
/// any, ids as two halves (id_high, id_low: PLY has no 64 bits); OBJ: an object `component_LABEL` for each,
/// lines as `l`. Where a mesh is cut, its line in the file says ", which goes round ..." (cutNote; empty for
/// others).
void writeMeshPly(const std::filesystem::path& file, const std::vector<ComponentMesh>& meshes);
void writeMeshObj(const std::filesystem::path& file, const std::vector<ComponentMesh>& meshes);
std::string cutNote(const ComponentMesh& mesh);

}  // namespace thaw
