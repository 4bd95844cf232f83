// SPDX-License-Identifier: Apache-2.0
// Meshes of surface components with a choice of detail.
#pragma once
#include "core/walls/walls.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

struct MeshDetail {
  double cell = 1;           ///< edge of the cubes, in mean radii of the surfels
  double mostOfSize = 0.15;  ///< largest edge of the cubes, as a fraction of the size of the component. 0.15
                             ///< keeps drops of a few surfels spherical
  const Walls* walls = nullptr;  ///< walls at the time of the frame, at which the mesh ends, except for walls
                                 ///< with a surfel deeper than its radius
  bool improved = true;          ///< without slivers (improve_triangles.hpp), which takes most of the time
};

/// As meshOfComponent, with this detail.
ComponentMesh detailedMeshOfComponent(const SurfaceFrame& frame, const ComponentRows& component,
                                      const std::vector<Rgb>& colours, const PeriodicSides& sides,
                                      const MeshDetail& detail);

}  // namespace thaw
