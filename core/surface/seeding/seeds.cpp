// SPDX-License-Identifier: Apache-2.0
#include "core/surface/seeding/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/hash_random.hpp"
#include "core/math/tangent.hpp"
#include "core/surface/data/sampled_bodies.hpp"
#include "core/surface/data/surfel_ids.hpp"
#include "core/surface/field/iso_surface.hpp"

namespace thaw {

int seedsOf(const Scene& scene, const Surface& surface) {
  const double fine = scene.spacing / surface.spacing;
  return static_cast<int>(std::clamp(7 * fine * fine, 16.0, 120.0));
}

SeedDirections::SeedDirections(const Scene& scene, const Surface& surface) : seed_(scene.seed) {
  constexpr double goldenAngle = 2.39996322972865332;
  const int seeds = seedsOf(scene, surface);
  for (int k = 0; k < seeds; k++) {
    const double z = 1 - (2.0 * k + 1) / seeds, across = std::sqrt(1 - z * z);
    at_.push_back({across * std::cos(goldenAngle * k), across * std::sin(goldenAngle * k), z});
  }
}

void SeedDirections::turn(std::uint64_t id) {
  const double angle = 2 * std::numbers::pi * randomUniform(seed_, Purpose::SurfelSample, id);
  cosine_ = std::cos(angle);
  sine_ = std::sin(angle);
}

void seedsOnSurface(FieldProbe& probe, std::size_t i, const Vec3d* u, std::size_t n,
                    std::optional<SurfacePoint>* found) {
  const SurfaceParticles& p = probe.surface().particles;
  const double dx = probe.scene().spacing;
  std::array<Vec3d, FieldProbe::most> from;
  for (std::size_t k = 0; k < n; k++) from[k] = p.position[i] + u[k] * (0.6 * dx);
  projectToIsoSurface(probe, {p.component[i], p.position[i], 1.2 * dx}, {from.data(), n}, found);
  for (std::size_t k = 0; k < n; k++) {
    if (!found[k]) continue;
    const Vec3d d = found[k]->position - p.position[i];
    if (!(dot(d, d) <= 1.44 * dx * dx && dot(d, found[k]->normal) > 0)) found[k] = {};
  }
}

SurfelRow seedSurfel(const SurfaceView& w, std::size_t i, int k, const SurfacePoint& at) {
  const SurfaceParticles& p = w.surface.particles;
  SurfelRow r;
  r.id = surfelBit | birthBit |
         randomBits(w.scene.seed, Purpose::SurfelBirth, p.id[i],
                    static_cast<std::uint64_t>(w.clock.step) << 10 | static_cast<std::uint64_t>(k));
  r.component = p.component[i];
  r.position = at.position;
  r.normal = at.normal;
  r.tangent = anyTangent(at.normal);
  r.radius = w.surface.spacing;
  r.colour = surfaceColour(w.scene, p.body[i]);
  r.particle = static_cast<std::uint32_t>(i);
  if (p.liquid.active) r.liquid = p.liquid[i];
  if (p.temperature.active) r.temperature = p.temperature[i];
  return r;
}

}  // namespace thaw
