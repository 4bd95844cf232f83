// SPDX-License-Identifier: Apache-2.0
// First surfels of bodies with known surfaces: meshes, and solids of other shapes.
#pragma once
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/halo/surface_halos.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

inline constexpr std::uint64_t surfelBit = std::uint64_t{1} << 63;  ///< set in the id of every surfel
inline constexpr std::uint64_t birthBit = std::uint64_t{1} << 62;   ///< set in the ids of surfels that were
                                                                    ///< not sampled

/// Returns the surface colour for particles of a body or emitter (Continuum::body): that of their material,
/// or the default for surfaces without a scene.
inline std::uint32_t surfaceColour(const Scene& scene, std::size_t source) {
  const std::size_t bodies = scene.bodies.size();
  if (source >= bodies + scene.emitters.size()) return Material{}.colour;
  const int material = source < bodies ? scene.bodies[source].material
                                       : scene.emitters[source - bodies].material;
  return static_cast<std::size_t>(material) < scene.materials.size()
             ? scene.materials[static_cast<std::size_t>(material)].colour
             : Material{}.colour;
}

/// Sample of a body's surface.
struct SurfaceSample {
  Vec3d position{}, normal{};  ///< m, unit
  std::uint32_t colour = 0;
  bool coloured = false;  ///< the mesh has a colour there
};

/// Returns whether the surface of this body is sampled from its mesh.
bool hasMesh(const Scene& scene, std::size_t body);

/// Returns whether the surface of this body is sampled from its mesh or shape, instead of grown from its
/// particles. Shapes are sampled for initial solids only: liquid surfaces would move to the colour's level at
/// once. Where other bodies cut a body, its surface follows the remaining particles.
bool isSampled(const Scene& scene, std::size_t body);

/// Returns blue-noise samples, `spacing` (m) apart, of a shape. Meshes give normals and colours; buried parts
/// are left out. Samples of the built-in bust are projected onto the sculpture, which its mesh approximates.
/// Other shapes are sampled on the meshes of their parts (shapeMesh) and projected onto the exact surface,
/// with sharp edges and corners.
std::vector<SurfaceSample> sampleShape(const Shape& shape, const MeshLoader& load, double spacing,
                                       std::uint64_t seed);

/// Appends the surfels of all sampled bodies, except faces at the body's own periodic image. They are
/// distributed over the ranks until placeRows, without components until labelNewParticles. Every rank samples
/// every body, so that the result does not depend on the distribution.
void sampleMeshes(const Scene& scene, Surface& surface, const MeshLoader& load, const Reducer& all);

/// Projects births of resampling on sampled bodies, beyond their edges, back onto the bodies' surfaces. The
/// bust is excluded, because its sculpture is finer than its mesh.
void putBirthsOnShapes(const Scene& scene, Surface& surface, const MeshLoader& load);

}  // namespace thaw
