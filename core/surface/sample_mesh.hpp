// The first surfels of bodies whose surface is known: meshes, and solids of any other shape.
#pragma once
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

inline constexpr std::uint64_t surfelBit = std::uint64_t{1} << 63;  ///< of every surfel's id
inline constexpr std::uint64_t birthBit = std::uint64_t{1} << 62;   ///< of those that were not sampled

/// Colour of the surface around particles of a body or emitter (Continuum::body): that of their material; of
/// a surface without a scene the default.
inline std::uint32_t surfaceColour(const Scene& scene, std::size_t source) {
  const std::size_t bodies = scene.bodies.size();
  if (source >= bodies + scene.emitters.size()) return Material{}.colour;
  const int material = source < bodies ? scene.bodies[source].material
                                       : scene.emitters[source - bodies].material;
  return static_cast<std::size_t>(material) < scene.materials.size()
             ? scene.materials[static_cast<std::size_t>(material)].colour
             : Material{}.colour;
}

/// A sample of a body's surface.
struct SurfaceSample {
  Vec3d position{}, normal{};  ///< m, unit
  std::uint32_t colour = 0;
  bool coloured = false;  ///< by the mesh
};

/// Is the surface of this body sampled from its mesh?
bool hasMesh(const Scene& scene, std::size_t body);

/// Is the surface of this body sampled from its mesh or its shape, rather than grown from its particles?
/// Shapes are, of what begins solid: liquids would leave them at once for the level of the colour field.
/// Where overlapping bodies are cut by others, surfaces follow the particles that are left.
bool isSampled(const Scene& scene, std::size_t body);

/// Blue noise on the placed mesh of a shape of kind Mesh, `spacing` (m) apart, with its normals and colours;
/// on the built-in bust the places are moved onto the sculpture that its mesh only comes near to, and have
/// its normals. Parts buried in other parts are left out. Of other shapes the same on their parts
/// (shapeMesh), moved onto the exact surface: faces, edges and corners are sharp.
std::vector<SurfaceSample> sampleShape(const Shape& shape, const MeshLoader& load, double spacing,
                                       std::uint64_t seed);

/// Appends the surfels of all bodies that are sampled, but for faces that meet the body's own image across a
/// periodic side; dealt out to the ranks (placeRows brings them home), of no component yet: adoptFresh finds
/// it. Every rank samples every body, so that nothing depends on who does what.
void sampleMeshes(const Scene& scene, Surface& surface, const MeshLoader& load, const Reducer& all);

/// What resampling has born on the surfaces of sampled bodies, past their edges, back onto them. The bust's
/// mesh is none: its sculpture is finer.
void putBirthsOnShapes(const Scene& scene, Surface& surface, const MeshLoader& load);

}  // namespace thaw
