// SPDX-License-Identifier: Apache-2.0
// Drops of few particles. Their surface is a sphere that every update rebuilds (renewSurfels).
#pragma once
#include "core/surface/measures/measure.hpp"

namespace thaw {

/// Largest number of particles of a drop with a spherical surface (docs/validation/stability.md, row 21).
inline constexpr std::int64_t smallDrop = 4;

/// Returns whether the component of a label was a small drop at the last update. Caches the last label, since
/// rows of a component are mostly consecutive.
class SmallDrops {
 public:
  explicit SmallDrops(const Surface& surface) : surface_(surface) {}
  bool operator()(std::uint64_t label) {
    if (label != last_) {
      last_ = label;
      const SurfaceComponent* c = findComponent(surface_, label);
      small_ = c && c->particles <= smallDrop;
    }
    return small_;
  }

 private:
  const Surface& surface_;
  std::uint64_t last_ = noComponent;
  bool small_ = false;
};

}  // namespace thaw
