// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/initial_fill.hpp"

#include <algorithm>

#include "core/surface/seeding/sample_mesh.hpp"

namespace thaw {

bool hasInitialFill(const Scene& s, std::size_t b) {
  return s.surface.on && s.bodies[b].packing == Packing::Lattice && !hasMesh(s, b);
}

bool anyInitialFill(const Scene& s) {
  for (std::size_t b = 0; b < s.bodies.size(); b++)
    if (hasInitialFill(s, b)) return true;
  return false;
}

void normaliseInitialFill(const Scene& s, Continuum& p, std::span<const std::int64_t> parts,
                          std::span<const std::int64_t> particles) {
  constexpr double least = 0.4, most = 1.6;
  for (std::size_t i = 0; i < p.owned; i++) {
    const std::size_t b = p.body[i];
    if (!hasInitialFill(s, b) || parts[b] == 0) continue;
    const double mean = static_cast<double>(parts[b]) / static_cast<double>(particles[b]);
    p.initialFill[i] = static_cast<float>(
        std::clamp(static_cast<double>(p.initialFill[i]) / mean, least, most));
  }
}

}  // namespace thaw
