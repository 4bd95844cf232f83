#include "core/fluid/lattice_relief.hpp"

#include "core/fluid/free_surface.hpp"
#include "core/fluid/particle_pressure.hpp"

namespace thaw {
namespace {

/// Share of the force that is taken away. With 1 nothing keeps the particles evenly spaced.
constexpr double reliefShare = 0.65;
/// Share of solid neighbours at which half of the force acts: a distance of 0.95 support radii. It bounds the
/// force of pairs that come closer within half a step.
constexpr double faintContact = 1e-5;

bool isRelieved(const World& w, const StepTools& t, std::size_t i) {
  const Continuum& p = w.particles;
  return liquidFraction(p, i) == 1 && p.solidFraction[i] > 0 && !p.atSurface[i] && !besideSurface(p, i) &&
         !(w.modules.sleep && t.sleep.deep[i]);
}

}  // namespace

void findLatticeRelief(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  const Numerics& n = w.scene.numerics;
  for (std::size_t i = 0; i < p.owned; i++) {
    p.relief[i] = {};
    if (!isRelieved(w, t, i)) continue;
    const LiquidMaterial& m = t.liquids[p.material[i]];
    const double pressure = pressureOf(n.eos, m.stiffness, 1 + p.compression[i], n.tensileLimit);
    const double volume = p.mass[i] * m.restVolume, share = static_cast<double>(p.solidFraction[i]);
    p.relief[i] = single(wide(p.concentrationGradient[i]) *
                         (2 * reliefShare * pressure * volume / (w.grid.support * (share + faintContact))));
  }
}

}  // namespace thaw
