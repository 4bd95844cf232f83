// SPDX-License-Identifier: Apache-2.0
#include "core/surface/data/sampled_bodies.hpp"

#include "core/materials/enthalpy.hpp"

namespace thaw {

bool hasMesh(const Scene& scene, std::size_t body) {
  return scene.surface.source == SurfelSource::Automatic && body < scene.bodies.size() &&
         scene.bodies[body].shape.kind == ShapeKind::Mesh;
}

bool isSampled(const Scene& scene, std::size_t body) {
  if (hasMesh(scene, body)) return true;
  if (scene.surface.source != SurfelSource::Automatic || body >= scene.bodies.size()) return false;
  const OverlapRule rule = scene.numerics.overlap;
  const Body& b = scene.bodies[body];
  const auto material = static_cast<std::size_t>(b.material);
  if (material >= scene.materials.size() || rule == OverlapRule::RemoveLater ||
      rule == OverlapRule::RemoveEarlier)
    return false;
  const Material& m = scene.materials[material];
  // Parts of the body may be liquid.
  if (b.temperatureField && m.melts()) return false;
  return m.canBeSolid() && paperFraction(m, b.temperature) == 0;
}

}  // namespace thaw
