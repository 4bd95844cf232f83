// SPDX-License-Identifier: Apache-2.0
// Light on surfels: a sun disc and a sky dome, with shadows of casters.
#pragma once
#include <vector>

#include "io/render/light/backdrop.hpp"
#include "io/render/surfels/splat_faces.hpp"

namespace thaw {

/// Samples of the sun's disc and the sky.
struct SurfelLights {
  Lights lights;  // its sun has a direction only
  std::vector<DepthMap> sun;
};

SurfelLights makeSurfelLights(const Discs& casters, const std::vector<LightSource>& sources, int threads);

/// Returns the visible fraction of a light's disc at a surfel; penumbras widen with the distance of the
/// caster.
float lightSeen(std::span<const DepthMap> maps, const Vec3f& point, const Vec3f& normal, float radius);

/// Returns the light of all sources beside the sun on a surfel, without highlights.
Light moreLight(const Lights& lights, const Vec3f& point, const Vec3f& normal, float radius);

/// Returns the sky's light on a surfel, with reflection by the floor.
float skySeen(const SurfelLights& lights, const Backdrop& backdrop, const Vec3f& point, const Vec3f& normal,
              float radius);

/// Returns the light of a surface sample towards the camera.
Light surfaceLight(const SurfelShade& shade, const Vec3f& ray, const LightSource& sun);

}  // namespace thaw
