// SPDX-License-Identifier: Apache-2.0
// Seed positions on the surface around a particle for new surfels.
#pragma once
#include <algorithm>
#include <vector>

#include "core/surface/data/surface_view.hpp"
#include "core/surface/field/iso_surface.hpp"
#include "core/surface/resampling/births.hpp"

namespace thaw {

/// Particles with at least this colour are inner particles, away from the surface.
inline constexpr float innerColour = 0.97f;

/// Returns the number of seeds around a particle. It depends on the surfel spacing.
int seedsOf(const Scene& scene, const Surface& surface);

/// Seed directions, evenly spread on a sphere with a random rotation for each particle.
class SeedDirections {
 public:
  SeedDirections(const Scene& scene, const Surface& surface);
  void turn(std::uint64_t particleId);
  int count() const { return static_cast<int>(at_.size()); }
  Vec3d operator[](int k) const {
    const Vec3d& d = at_[static_cast<std::size_t>(k)];
    return {cosine_ * d.x - sine_ * d.y, sine_ * d.x + cosine_ * d.y, d.z};
  }

 private:
  std::uint64_t seed_;
  double cosine_ = 1, sine_ = 0;
  std::vector<Vec3d> at_;
};

/// Seed directions of a particle that no other particle blocks.
class FreeDirections {
 public:
  void begin(const SeedDirections& seeds) {
    const auto n = static_cast<std::size_t>(seeds.count());
    x_.resize(n), y_.resize(n), z_.resize(n);
    nearest_.assign(n, -1);
    for (std::size_t k = 0; k < n; k++) {
      const Vec3d u = seeds[static_cast<int>(k)];
      x_[k] = static_cast<float>(u.x), y_[k] = static_cast<float>(u.y), z_[k] = static_cast<float>(u.z);
    }
  }
  /// Blocks directions near the unit vector d to a particle.
  void take(const Vec3d& d) {
    const float dx = static_cast<float>(d.x), dy = static_cast<float>(d.y), dz = static_cast<float>(d.z);
    for (std::size_t k = 0; k < x_.size(); k++)
      nearest_[k] = std::max(nearest_[k], dx * x_[k] + dy * y_[k] + dz * z_[k]);
  }
  bool taken(int k) const { return nearest_[static_cast<std::size_t>(k)] > takenFrom; }

 private:
  // cosine of 41 degrees: particles at smaller angles block a direction
  static constexpr float takenFrom = 0.75f;
  // nearest: cosine of the angle to the nearest particle's direction
  std::vector<float> x_, y_, z_, nearest_;
};

/// Finds the surface points of particle i (row of the copies) in n <= FieldProbe::most directions u.
/// Directions without a surface nearby give nothing.
void seedsOnSurface(FieldProbe& probe, std::size_t i, const Vec3d* u, std::size_t n,
                    std::optional<SurfacePoint>* found);

/// Returns a new surfel of particle i at a surface point. Its id depends on the particle, the step and k. Its
/// colour is the material's; see inheritColours.
SurfelRow seedSurfel(const SurfaceView& view, std::size_t i, int k, const SurfacePoint& at);

}  // namespace thaw
