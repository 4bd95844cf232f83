// SPDX-License-Identifier: Apache-2.0
// First surfels of bodies with known surfaces: meshes, and solids of other shapes.
#pragma once
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/halo/surface_halos.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/sampled_bodies.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/data/surfel_ids.hpp"

namespace thaw {

/// Sample of a body's surface.
struct SurfaceSample {
  Vec3d position{}, normal{};  ///< m, unit
  std::uint32_t colour = 0;
  bool coloured = false;  ///< the mesh has a colour there
};

/// Returns blue-noise samples, `spacing` (m) apart, of a shape. Meshes give normals and colours; buried parts
/// are omitted. Samples of the built-in bust are projected onto the exact sculpture, because its mesh is an
/// approximation. Other shapes are sampled on the meshes of their parts (shapeMesh) and projected onto the
/// exact surface, with sharp edges and corners.
std::vector<SurfaceSample> sampleShape(const Shape& shape, const MeshLoader& load, double spacing,
                                       std::uint64_t seed);

/// Returns the samples of a sampled body in the order of their ids (`surfelBit | particleId(body, k)`),
/// without faces at its own periodic image. period: m, 0 along axes without periodic sides.
std::vector<SurfaceSample> sampleBody(const Scene& scene, std::size_t body, const MeshLoader& load,
                                      const Vec3d& period);

/// Appends the surfels of all sampled bodies, except faces at the body's own periodic image. They are
/// distributed over the ranks until placeRows, and have no components until labelNewParticles. Every rank
/// samples every body, so the result does not depend on the distribution.
void sampleMeshes(const Scene& scene, Surface& surface, const MeshLoader& load, const Reducer& all);

/// Projects births of resampling on sampled bodies, beyond their edges, back onto the bodies' surfaces. The
/// bust is excluded, because the sculpture is finer than the mesh.
void putBirthsOnShapes(const Scene& scene, Surface& surface, const MeshLoader& load);

}  // namespace thaw
