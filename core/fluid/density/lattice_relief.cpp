// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/density/lattice_relief.hpp"

#include "core/fluid/density/free_surface.hpp"
#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw {
namespace {

/// Share of the force that is taken away. With 1 nothing keeps the particles evenly spaced.
constexpr double reliefShare = 0.65;
/// Share of solid neighbours at which half of the force acts: a distance of 0.95 support radii. It bounds the
/// force of pairs that come closer within half a step.
constexpr double faintContact = 1e-5;

bool isRelieved(const ReliefContext& x, const Continuum& p, std::size_t i) {
  return liquidFraction(p, i) == 1 && p.solidKernelSum[i] > 0 && !p.atSurface[i] && !besideSurface(p, i) &&
         (x.asleep.empty() || !x.asleep[i]);
}

}  // namespace

void findLatticeRelief(const ReliefContext& x, Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) {
    p.relief[i] = {};
    if (!isRelieved(x, p, i)) continue;
    const LiquidMaterial& m = x.liquids[p.material[i]];
    const double pressure = pressureOf(x.numerics.eos, m.stiffness, 1 + p.compression[i],
                                       x.numerics.tensileLimit),
                 volume = p.mass[i] * m.restVolume, share = static_cast<double>(p.solidKernelSum[i]);
    p.relief[i] = single(wide(p.concentrationGradient[i]) *
                         (2 * reliefShare * pressure * volume / (x.support * (share + faintContact))));
  }
}

}  // namespace thaw
