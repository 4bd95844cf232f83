// SPDX-License-Identifier: Apache-2.0
// Closed triangle meshes of surface components.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "io/frames/read_surface_frame.hpp"
#include "io/surface_mesh/unwrap_component.hpp"

namespace thaw {

/// Triangles around one component. Every edge has two triangles with opposite directions.
struct ComponentMesh {
  std::uint64_t component = 0;
  std::string name;  ///< an obstacle, a sheet or an oriented body; empty for components of a surface
  std::string body;  ///< name of a component after its body or emitter; empty if that is unknown
  TriangleMesh mesh;
  std::vector<Vec3f> colours;             ///< per vertex, sRGB 0 to 255, from nearby surfels
  std::vector<Vec3f> normals;             ///< per vertex, unit, outward
  std::vector<Vec3f> velocities;          ///< m/s, per vertex, or empty
  std::vector<float> temperatures;        ///< K, per vertex, or empty
  std::vector<float> liquid;              ///< 1, liquid fraction per vertex, or empty
  std::vector<std::array<float, 2>> uvs;  ///< texture coordinates, per vertex, or empty
  std::vector<std::uint64_t> ids;         ///< per vertex, of its row; empty for meshes around surfels
  std::vector<std::array<std::uint32_t, 2>> lines;  ///< joined vertices of a curve
  double asked = 0, edge = 0;                       ///< m, requested and used edge of cubes
  std::array<bool, 3> cut{};  ///< per axis: it extends through the periodic sides and ends there with flat
                              ///< caps
};

/// Surfels of each component, ascending by label; in frame order within one.
struct ComponentRows {
  std::uint64_t component = 0;
  std::vector<std::uint32_t> rows;
};
std::vector<ComponentRows> rowsByComponent(const SurfaceFrame& frame);

/// Returns the zero set of the weighted mean of signed plane distances (KO05), corrected for curvature by the
/// mean normal. The mean is over near surfels whose normals agree with the nearest one's. Marching cubes have
/// an edge of `cell` times the mean radius, at most 0.15 of the component's size. The edge is halved up to
/// three times if a component yields no triangle. Vertices lie on the zero set up to the offset of
/// offset_vertices.hpp. `colours`: one per surfel of the frame, copied to vertices. Returns no triangles if
/// the component encloses nothing at an eighth of the edge. Memory scales with the number of surfels. Across
/// periodic sides the mesh is unwrapped (unwrap_component.hpp); a component that joins its own image is cut
/// there.
ComponentMesh meshOfComponent(const SurfaceFrame& frame, const ComponentRows& component,
                              const std::vector<Rgb>& colours, const PeriodicSides& sides = {},
                              double cell = 1);

}  // namespace thaw
