// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/surfel_lights.hpp"

#include <algorithm>
#include <cmath>

#include "io/image/parallel_for.hpp"

namespace thaw {

namespace {

constexpr int sunDirections = 16, skyDirections = 40;

}  // namespace

SurfelLights makeSurfelLights(const Discs& discs, const std::vector<LightSource>& sources, int threads) {
  SurfelLights all;
  double sum = 0;
  for (float r : discs.radii) sum += r;
  all.lights.radius = discs.radii.empty() ? 0
                                          : static_cast<float>(sum / static_cast<double>(discs.radii.size()));
  all.lights.source = sources[0];
  const std::vector<Vec3f> sun = lightDisc(sources[0], sunDirections), sky = skyDome(skyDirections);
  all.sun.resize(sun.size());
  all.lights.sky.resize(sky.size());
  parallelFor(sun.size() + sky.size(), threads, [&](std::size_t k) {
    if (k < sun.size()) all.sun[k] = makeDepthMap(discs, sun[k], 2.0f, 1024);
    else all.lights.sky[k - sun.size()] = makeDepthMap(discs, sky[k - sun.size()], 1.3f, 512);
  });
  for (std::size_t l = 1; l < sources.size(); l++) {
    const std::vector<Vec3f> disc = lightDisc(sources[l], sunDirections);
    all.lights.more.push_back({sources[l], std::vector<DepthMap>(disc.size())});
    parallelFor(disc.size(), threads, [&](std::size_t k) {
      all.lights.more.back().maps[k] = makeDepthMap(discs, disc[k], 2.0f, 1024);
    });
  }
  return all;
}

float lightSeen(std::span<const DepthMap> maps, const Vec3f& point, const Vec3f& normal, float radius) {
  float seen = 0;
  for (const DepthMap& map : maps) seen += map.visible(point + (0.5f * radius) * normal, 0.6f * radius, 0);
  return seen / static_cast<float>(maps.size());
}

Light moreLight(const Lights& lights, const Vec3f& point, const Vec3f& normal, float radius) {
  Light sum{};
  for (const SideLight& light : lights.more) {
    const float facing = dot(normal, light.source.toLight);
    if (!(facing > 0)) continue;
    Light here = (facing * lightSeen(light.maps, point, normal, radius)) * light.source.colour;
    if (!light.glass.empty()) here = product(here, light.glass.at(point + radius * normal));
    sum += here;
  }
  return sum;
}

float skySeen(const SurfelLights& lights, const Backdrop& backdrop, const Vec3f& point, const Vec3f& normal,
              float radius) {
  float light = 0, full = 0, open = 0;
  const Vec3f from = point + (0.5f * radius) * normal;
  for (const DepthMap& map : lights.lights.sky) {
    const float facing = dot(normal, map.toLight) + 0.15f;  // light from slightly below the horizon counts,
                                                            // as from a sky
    full += map.toLight.z + 0.15f;
    if (facing <= 0) continue;
    const float visible = map.visible(from, 0.9f * radius, 0);
    light += facing * visible;
    open += visible;
  }
  const float below = 0.24f * (1 - normal.z) *
                      (0.35f + 0.65f * open / static_cast<float>(lights.lights.sky.size()));
  return light / full + below * backdrop.bounce(point);
}

Light surfaceLight(const SurfelShade& s, const Vec3f& ray, const LightSource& source) {
  const Vec3f& toSun = source.toLight;
  const Vec3f back = ray * (-1 / std::sqrt(dot(ray, ray))), sum = toSun + back;
  const float facing = std::max(0.0f, dot(s.normal, toSun)) * s.sun;
  const float half = std::max(0.0f, dot(s.normal, sum)) / std::sqrt(std::max(1e-12f, dot(sum, sum)));
  float shine = half * half;  // half^48
  shine *= shine * shine;
  shine *= shine, shine *= shine, shine *= shine;
  // reflection grows at grazing angles
  const float edge = 1 - std::max(0.0f, dot(s.normal, back)), rim = 0.05f * edge * edge * edge * edge;
  const Light bright = (facing > 0 ? 0.10f * s.sun * shine : 0.0f) * source.colour + Light{rim, rim, rim};
  return s.fromSky + facing * s.ofSun + bright;
}

}  // namespace thaw
