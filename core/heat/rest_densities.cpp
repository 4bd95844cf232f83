// SPDX-License-Identifier: Apache-2.0
#include "core/heat/rest_densities.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/materials/rest_density.hpp"
#include "core/particles/sleep_stage.hpp"

namespace thaw {
namespace {

/// Returns the derivative (J) of all energies of tension with respect to the logarithm of a particle's
/// volume, at fixed positions. tension: energy (J) of the particle. The energy of a pair is proportional to
/// both volumes. A surface energy is proportional to the particle's own volume. Its gradient and colour are
/// proportional to the neighbours' volumes.
double tensionByVolume(const RecordContext& x, const Continuum& p, std::size_t i, double tension) {
  if (!x.modules.surfaceEnergy) return 2 * tension;
  return tension + p.mass[i] / p.restDensity[i] *
                       (dot(p.surfaceEnergyByGradient[i], p.surfaceGradient[i]) +
                        p.surfaceEnergyByColour[i] * p.surfaceColour[i]);
}

/// Returns the pressure work (J) on a volume that grows by the ratio, with a summed density. Assumes that
/// neighbours have the particle's own pressure.
double workOfGrowth(const RecordContext& x, const Continuum& p, std::size_t i, double ratio) {
  const double relativeDensity = static_cast<double>(p.relativeDensity[i]);
  if (x.modules.incompressible || !(relativeDensity > 0)) return 0;
  const double f = liquidFraction(p, i), V = p.mass[i] / p.restDensity[i] * (ratio - 1);
  const Numerics& n = x.scene.numerics;
  return f * V * pressureOf(n.eos, x.liquids[p.material[i]].stiffness, relativeDensity, n.tensileLimit) /
         relativeDensity;
}

/// Pressure term p / delta^2 (Pa) at a relative density of 1 + y.
double pressureTerm(const RecordContext& x, const Continuum& p, std::size_t i, double y) {
  const Numerics& n = x.scene.numerics;
  return pressureOf(n.eos, x.liquids[p.material[i]].stiffness, 1 + y, n.tensileLimit) / ((1 + y) * (1 + y));
}

/// Scales a carried density by ratio^(f (2 - f)). The exponent is the pair weight f_i + f_j - f_i f_j of the
/// density rate for equal liquid fractions. Returns workOfLateKick.
double changeCompression(const RecordContext& x, Continuum& p, std::size_t i, double ratio, double dt) {
  const double f = liquidFraction(p, i), before = p.compression[i],
               after = (1 + before) * std::pow(ratio, f * (2 - f)) - 1;
  p.compression[i] = after;
  return workOfLateKick(x, p, i, before, dt);
}

/// Changes a rest density to increase the volume by `ratio`. Returns the increase of stored energy (J).
double growVolume(const RecordContext& x, Continuum& p, std::size_t i, std::span<const double> pairEnergy,
                  double ratio, double dt) {
  const double before = compressionOf(x, p, i, liquidFraction(p, i));
  double added = 0;
  if (x.modules.tension) added = tensionByVolume(x, p, i, pairEnergy[i] - before) * std::log(ratio);
  if (!x.modules.continuity) added += workOfGrowth(x, p, i, ratio);
  p.restDensity[i] /= ratio;
  if (x.modules.continuity) added += changeCompression(x, p, i, ratio, dt);
  return added + compressionOf(x, p, i, liquidFraction(p, i)) - before;
}

}  // namespace

double workOfLateKick(const RecordContext& x, const Continuum& p, std::size_t i, double before, double dt) {
  const double flow = static_cast<double>(p.compressionRate[i]) * dt;
  return 0.5 * flow * restVolumeOf(p, x.scene.materials, i) *
         (pressureTerm(x, p, i, p.compression[i]) - pressureTerm(x, p, i, before));
}

void updateRestDensities(const HeatView& w, const RecordContext& x, std::span<const double> pairEnergy,
                         double dt) {
  Continuum& p = w.particles;
  const std::vector<Material>& materials = w.scene.materials;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Material& m = materials[p.material[i]];
    if (!hasPhaseDensities(m) || (p.sleep.active && p.sleep[i] != awake)) continue;
    const double target = targetRestDensity(m, static_cast<Phase>(p.phase[i]), liquidFraction(p, i));
    if (p.restDensity[i] == target) continue;
    const double most = restDensityRate * x.liquids[p.material[i]].soundSpeed / x.grid.support * dt;
    const double growth = std::log(p.restDensity[i] / target);
    const double ratio = std::exp(std::clamp(growth, -most, most));
    w.ledger.phaseJump.add(-growVolume(x, p, i, pairEnergy, ratio, dt));
    if (std::abs(growth) <= most) p.restDensity[i] = target;
  }
}

}  // namespace thaw
