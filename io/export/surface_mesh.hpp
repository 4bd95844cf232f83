// Closed triangle meshes of the components of a surface.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "io/export/whole_component.hpp"
#include "io/output/read_surface_frame.hpp"

namespace thaw {

/// Triangles around one component. Every edge has two triangles that run along it in opposite directions.
struct ComponentMesh {
  std::uint64_t component = 0;
  TriangleMesh mesh;
  std::vector<Vec3f> colours;      ///< one a vertex, sRGB 0 to 255, of the surfels around
  std::vector<Vec3f> normals;      ///< one a vertex, unit, outward
  std::vector<std::uint64_t> ids;  ///< one a vertex, of its row; empty for meshes that are made around others
  std::vector<std::array<std::uint32_t, 2>> lines;  ///< vertices of a curve that are joined
  double asked = 0, edge = 0;  ///< m, of the cubes that were asked for, and that it is made with
  std::array<bool, 3> cut{};  ///< by axis: it goes round the periodic sides there, and ends at them with flat
                              ///< caps
};

/// Surfels of each component, ascending by its label; within one, in the order of the frame.
struct ComponentRows {
  std::uint64_t component = 0;
  std::vector<std::uint32_t> rows;
};
std::vector<ComponentRows> rowsByComponent(const SurfaceFrame& frame);

/// The zero set of the weighted mean of the surfels' signed plane distances (after Kolluri 2005, "Provably
/// good moving least squares"), corrected for curvature by the mean normal, over those near a place whose
/// normals agree with the nearest one's, by marching tetrahedra on cubes of edge `cell` times the mean
/// radius, or .15 of its size where that is less, half of that and again where a component is too small to
/// show. Vertices lie on the zero set but for what makes facets straddle it (straddle.hpp). `colours`: one a
/// surfel of the frame, copied to the vertices. Empty if the component encloses nothing at an eighth of it.
/// Memory follows the number of surfels, not the size of the box around them. Across periodic sides the mesh
/// is in one piece (whole_component.hpp); a component that goes round ends at them.
ComponentMesh meshOfComponent(const SurfaceFrame& frame, const ComponentRows& component,
                              const std::vector<Rgb>& colours, const PeriodicSides& sides = {},
                              double cell = 1);

}  // namespace thaw
