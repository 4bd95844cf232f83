// SPDX-License-Identifier: Apache-2.0
// Directions of a particle that the surface covers.
#pragma once
#include <array>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/surface/kernels/surface_kernels.hpp"
#include "core/surface/search/local_surface.hpp"

namespace thaw {

/// Surfels around a particle, relative to it (m), as separate arrays for vector instructions.
class DiscCover {
 public:
  /// spacing: m, of the particles. Discs more than `reach` spacings above or below a position do not cover
  /// it.
  DiscCover(double spacing, double reach)
      : most_(static_cast<float>(reach * spacing)), half_(static_cast<float>(0.5 * spacing)) {}
  void clear() { size_ = 0, closed_ = false; }
  void add(const Vec3d& d, const Vec3d& n, double r) {
    if (size_ + padding > x_.size())
      for (auto* v : all()) v->resize(2 * (size_ + padding));
    put(d, n, r * r);
    closed_ = false;
  }
  /// Returns whether a disc lies above, below or at the position half a spacing away in direction u, or at
  /// `place` relative to the particle.
  bool covers(const Vec3d& u) { return covers(static_cast<double>(half_) * u, u); }
  bool covers(const Vec3d& place, const Vec3d& normal) {
    if (size_ == 0) return false;
    if (!closed_) {
      const std::size_t n = size_;
      for (std::size_t k = 1; k < padding; k++) put({}, {}, 0);
      size_ = n, closed_ = true;
    }
    const DiscsAround discs{x_.data(),  y_.data(),  z_.data(), nx_.data(), ny_.data(),
                            nz_.data(), r2_.data(), size_,     most_,      static_cast<float>(oneSide)};
    const std::array<float, 3> p{static_cast<float>(place.x), static_cast<float>(place.y),
                                 static_cast<float>(place.z)},
        u{static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
    return bestSurfaceKernels().covered(discs, p.data(), u.data());
  }

 private:
  static constexpr std::size_t padding = 8;
  std::array<std::vector<float>*, 7> all() { return {&x_, &y_, &z_, &nx_, &ny_, &nz_, &r2_}; }
  void put(const Vec3d& d, const Vec3d& n, double r2) {
    const std::array<double, 7> values{d.x, d.y, d.z, n.x, n.y, n.z, r2};
    const auto to = all();
    for (std::size_t k = 0; k < to.size(); k++) (*to[k])[size_] = static_cast<float>(values[k]);
    size_++;
  }

  float most_, half_;
  std::size_t size_ = 0;
  // Padding after the last disc covers nothing.
  bool closed_ = false;
  std::vector<float> x_, y_, z_, nx_, ny_, nz_, r2_;
};

}  // namespace thaw
