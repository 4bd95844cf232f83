#include "core/surface/keep_volume.hpp"

#include <algorithm>
#include <cmath>

#include "core/surface/measure.hpp"

namespace thaw {

namespace {
constexpr std::int64_t fewest = 12;
}

double volumeError(const Surface& s) {
  double error = 0;
  for (const SurfaceComponent& c : s.components)
    if (c.surfels >= fewest && c.particleVolume > 0) error = std::max(error, std::abs(c.volume - c.particleVolume) / c.particleVolume);
  return error;
}

void offsetToVolume(Surface& s, double keepVolume) {
  Surfels& f = s.surfels;
  const double longest = 0.25 * s.spacing;
  const SurfaceComponent* c = nullptr;
  for (std::size_t i = 0; i < f.owned; i++) {
    if (!c || c->label != f.component[i]) c = findComponent(s, f.component[i]);
    if (!c || c->surfels < fewest || !(c->area > 0)) continue;
    f.position[i] += std::clamp(keepVolume * (c->particleVolume - c->volume) / c->area, -longest, longest) * f.normal[i];
  }
}

}  // namespace thaw
