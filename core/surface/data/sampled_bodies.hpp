// SPDX-License-Identifier: Apache-2.0
// Bodies whose surface is sampled, and colours of bodies.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/scene/scene.hpp"

namespace thaw {

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

/// Returns whether the surface of this body is sampled from its mesh.
bool hasMesh(const Scene& scene, std::size_t body);

/// Returns whether the surface of this body is sampled from its mesh or shape, instead of grown from its
/// particles. Shapes are sampled only for initial solids, because liquid surfaces would move to the colour's
/// level at once. Where other bodies cut a body, its surface follows the remaining particles.
bool isSampled(const Scene& scene, std::size_t body);

}  // namespace thaw
