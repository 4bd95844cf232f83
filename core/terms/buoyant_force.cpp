// SPDX-License-Identifier: Apache-2.0
#include "core/terms/buoyant_force.hpp"

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/scene/buoyancy.hpp"

namespace thaw {
namespace {

/// Returns the buoyant force (N). gravity: m/s^2, total gravity of the domain (gravityOf).
Vec3d buoyantForce(const Continuum& p, std::size_t i, const Vec3d& gravity) {
  return gravity * (-p.mass[i] * p.buoyancy[i]);
}

Vec3d gravityOf(const Domain& d) { return d.gravity + d.buoyantGravity; }

}  // namespace

void addBuoyancy(const Scene& s, Continuum& p) {
  const Vec3d g = gravityOf(s.domain);
  const double neutral = neutralDeficit(s);
  for (std::size_t i = 0; i < p.owned; i++) {
    p.buoyancy[i] = 0;
    const Material& m = s.materials[p.material[i]];
    const double f = p.phase[i] == Liquid ? liquidFraction(p, i) : 0;
    if (f == 0 || !isFree(p, i)) continue;
    const double deficit = expands(m) ? densityDeficit(s.domain, m, p.temperature[i]) : 0;
    p.buoyancy[i] = f * (deficit - neutral);
    p.force[i] += buoyantForce(p, i, g);
  }
}

void recordBuoyantKick(const Continuum& p, HalfKick kick, const Domain& d, double dt, Ledger& ledger) {
  const Vec3d g = gravityOf(d);
  const KickOfForce force{kick, d.gravity, dt};
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.buoyancy[i] != 0) force.record(p, i, buoyantForce(p, i, g), ledger);
}

}  // namespace thaw
