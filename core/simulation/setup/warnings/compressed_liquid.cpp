// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/compressed_liquid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/materials/state_equation.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {
namespace {

/// Advice for liquid that starts too close to walls or other bodies.
const char* remedyOf(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::Box: return "leave more room, or make thin boxes a whole number of spacings wide";
    case ShapeKind::Difference:
      return "enlarge the cut-out by half a spacing on each side, or leave more room";
    default: return "leave more room, or reduce the spacing";
  }
}

/// Returns the relative density that the liquid reaches with a carried density. The drift correction
/// tolerates a small excess of the summed density, and adds 5 % of the rest per acoustic time
/// (core/flow/density/carried_density.hpp). Meanwhile the particles move apart, within about two such times.
double reached(double summed) {
  constexpr double tolerated = 0.03, share = 0.1;
  return 1 + share * std::max(0.0, summed - 1 - tolerated);
}

}  // namespace

std::vector<SceneWarning> compressedLiquids(const World& w, const std::vector<LiquidMaterial>& liquids,
                                            Reducer& all) {
  std::vector<SceneWarning> warnings;
  const std::size_t bodies = w.scene.bodies.size();
  const double speed = expectedSpeed(w.scene);
  if (!w.modules.fluid || w.modules.incompressible || !(speed > 0) || bodies == 0) return warnings;
  constexpr double unit = 1e-6, share = 0.2;  // relative to speed^2; relative to the speed
  const Continuum& p = w.particles;
  std::vector<std::int64_t> sums(2 * bodies, 0);  // number of particles, and their compression energy per
                                                  // mass; integer sums do not depend on the order
  std::vector<double> densest(bodies, 0);
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.phase[i] != Liquid || p.body[i] >= bodies) continue;
    sums[2 * p.body[i]]++;
    const double summed = static_cast<double>(w.modules.continuity ? w.initialSummedDensity[i]
                                                                   : p.relativeDensity[i]),
                 density = w.modules.continuity ? reached(summed) : summed;
    if (!(density > 1)) continue;
    const double stiffness = liquids[p.material[i]].stiffness / w.scene.materials[p.material[i]].density;
    const double energy = compressionEnergy(w.scene.numerics.eos, stiffness, density, 0) / (speed * speed);
    sums[2 * p.body[i] + 1] += std::llround(std::min(energy, 1e6) / unit);
    densest[p.body[i]] = std::max(densest[p.body[i]], summed);
  }
  all.sum(sums);
  all.maximum(densest);
  for (std::size_t b = 0; b < bodies; b++) {
    if (sums[2 * b] == 0) continue;
    const double burst = std::sqrt(2 * unit * static_cast<double>(sums[2 * b + 1]) /
                                   static_cast<double>(sums[2 * b]));
    if (!(burst > share)) continue;
    char text[480];
    std::snprintf(
        text, sizeof text,
        "': its liquid starts compressed by up to %.2g %% and would burst at about %.2g m/s (expected speed "
        "of the scene: %.2g m/s). Particles are closer than half a spacing to a wall or another body; %s",
        100 * (densest[b] - 1), burst * speed, speed, remedyOf(w.scene.bodies[b].shape));
    warnings.push_back({w.scene.bodies[b].where, "body '" + w.scene.bodies[b].name + text});
  }
  return warnings;
}

}  // namespace thaw
