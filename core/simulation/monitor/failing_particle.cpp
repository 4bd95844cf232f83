// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/monitor/failing_particle.hpp"

#include <algorithm>
#include <cmath>

#include "core/simulation/time/integrate.hpp"

namespace thaw {
namespace {

/// Returns the quantity that this failure compares. The particle with the largest value is reported.
double failureMeasure(const World& w, Failure failure, Limit limitedBy, std::size_t i) {
  const Continuum& p = w.particles;
  const bool solid = p.solidIndex.active && p.solidIndex[i] != noSolid && p.solidIndex[i] < w.solids.owned;
  const double speed2 = dot(p.velocity[i], p.velocity[i]);
  const Vec3d x = p.position[i], f = forceOf(w.particles, w.scene, i);
  double g = speed2;
  if (failure == Failure::NotFinite && !std::isfinite(x.x + x.y + x.z + f.x + f.y + f.z)) g = never;
  if (failure == Failure::Density)
    g = p.phase[i] == Liquid && p.relativeDensity.active ? static_cast<double>(p.relativeDensity[i]) : 0;
  if (failure == Failure::Step && limitedBy != Limit::Speed) g = dot(p.acceleration[i], p.acceleration[i]);
  if (failure == Failure::Step && limitedBy == Limit::Elastic) {
    g = 0;
    for (int k = 0; solid && k < 3; k++)
      g += dot(w.solids.deformation[p.solidIndex[i]].row[k], w.solids.deformation[p.solidIndex[i]].row[k]);
  }
  if (failure == Failure::Inverted) g = solid ? -determinant(w.solids.deformation[p.solidIndex[i]]) : -never;
  if (failure == Failure::Energy || failure == Failure::Growth)
    g = 0.5 * speed2 + (solid && w.solids.energy.active ? w.solids.energy[p.solidIndex[i]] / p.mass[i] : 0);
  return std::isnan(g) ? never : g;
}

}  // namespace

FailingParticle findFailingParticle(const World& w, Failure failure, Limit limitedBy, Reducer& all) {
  const Continuum& p = w.particles;
  FailingParticle s;
  double most = -never;
  for (std::size_t i = 0; i < p.owned; i++) {
    const double g = failureMeasure(w, failure, limitedBy, i);
    if (g < most || (g == most && s.here && p.id[i] > p.id[s.row])) continue;
    s = {true, i, 0};
    most = g;
  }
  s.value = most;
  all.maximum({&s.value, 1});
  // Ids have up to 56 bits, but a double has only 53. The upper half is thus compared first, then the lower
  // half.
  s.here = s.here && most == s.value;
  for (const int shift : {32, 0}) {
    const double half = s.here ? -static_cast<double>(p.id[s.row] >> shift & 0xffffffffu) : -never;
    double lowest = half;
    all.maximum({&lowest, 1});
    s.here = s.here && half == lowest;
  }
  if (failure == Failure::Inverted) s.value = -s.value;
  else if (failure != Failure::Density && failure != Failure::Energy && failure != Failure::Growth)
    s.value = std::sqrt(std::max(0.0, s.value));
  return s;
}

}  // namespace thaw
