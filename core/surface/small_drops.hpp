// Drops of a few particles: their surface is a sphere, made anew in each update (renewSurfels), and nothing
// else works on it.
#pragma once
#include "core/surface/measure.hpp"

namespace thaw {

/// Drops of at most this many particles have a sphere for a surface (docs/validation/stability.md B21).
inline constexpr std::int64_t smallDrop = 4;

/// Whether the component of a label was a small drop at the last update. Rows of one component mostly follow
/// each other: the last answer is kept.
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
