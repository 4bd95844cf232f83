// What light reaches surfels: a sun with a disc, a sky with a dome, both seen past what casts shadows.
#pragma once
#include <vector>

#include "io/render/backdrop.hpp"
#include "io/render/splat_faces.hpp"

namespace thaw {

/// The sun's disc and the sky, as seen by surfels.
struct SurfelLights {
  Lights lights;  // its sun has a direction only
  std::vector<DepthMap> sun;
};

SurfelLights makeSurfelLights(const Discs& casters, const View& view, int threads);

/// Part of the sun's disc that a surfel sees: soft at the edge of a shadow by as much as what casts it is
/// away.
float sunSeen(const SurfelLights& lights, const Vec3f& point, const Vec3f& normal, float radius);

/// Light of the sky on a surfel, and what the floor throws back.
float skySeen(const SurfelLights& lights, const Backdrop& backdrop, const Vec3f& point, const Vec3f& normal,
              float radius);

/// The surface of a sample as the camera sees it.
Light surfaceLight(const SurfelShade& shade, const Vec3f& ray, const Vec3f& toSun);

}  // namespace thaw
