// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/solid_substeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/domain/sides.hpp"
#include "core/halo/exchange.hpp"
#include "core/particles/shifted.hpp"
#include "core/simulation/views/views.hpp"
#include "core/time/frame_times.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {
namespace {

void drift(World& w, double span, double far2) {
  const double share = 1.0 / w.clock.substeps;
  Continuum& p = w.particles;
  for (std::size_t s = 0; s < w.solids.owned; s++) {
    const std::uint32_t i = w.solids.particle[s];
    if (!takesSubsteps(p, i)) continue;
    Vec3d v = p.velocity[i];
    if (dot(v, v) > far2) {
      p.velocity[i].x = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    if (isShifted(p, i)) v += p.shiftingVelocity[i];
    p.position[i] += v * span;
    if (p.stepMeanVelocity.active) p.stepMeanVelocity[i] += v * share;
    if (const double potential = wrapPlace(w.grid, w.scene.domain, p.position[i]); potential != 0)
      w.ledger.entered.potential.add(p.mass[i] * potential);
  }
}

/// Computes Solids::force of bonds and of wall contacts.
void addFastForces(World& w, Halos& halos, StepTools& t, double span) {
  const ElasticStep now{span, false, false};
  copyToSolids(w.particles, w.solids);
  Exchange ends = refresh(halos.bonds, w.solids, remoteColumnsBeforeDeformation(w.solids));
  ElasticResult r = computeDeformationAndStress(t.solid.elastic, w.solids, w.bonds, now, SolidPart::Inner);
  t.times.lap(StepPhase::Elastic);
  ends.wait();
  t.times.lap(StepPhase::Bonds);
  r += computeDeformationAndStress(t.solid.elastic, w.solids, w.bonds, now, SolidPart::Boundary);
  w.counters.inverted += r.inverted;
  w.counters.softenedParticles += r.softenedParticles;
  t.times.lap(StepPhase::Elastic);
  ends = refresh(halos.bonds, w.solids, remoteColumnsBeforeForces(w.solids));
  t.times.lap(StepPhase::Bonds);
  computeElasticForces(t.solid.elastic, w.solids, w.bonds, now, SolidPart::Inner);
  t.times.lap(StepPhase::Elastic);
  ends.wait();
  t.times.lap(StepPhase::Bonds);
  computeElasticForces(t.solid.elastic, w.solids, w.bonds, now, SolidPart::Boundary);
  t.times.lap(StepPhase::Elastic);
  addSubstepContacts({wallView(w), t.walls.tables, t.liquids, span, span}, t.walls.substepContacts);
  t.times.lap(StepPhase::Walls);
}

void kick(Continuum& p, const Solids& solids, Ledger& ledger, double span) {
  const bool losses = solids.dissipated.active;
  for (std::size_t s = 0; s < solids.owned; s++) {
    const std::uint32_t i = solids.particle[s];
    if (!takesSubsteps(p, i)) continue;
    if (losses) p.dissipated[i] += solids.dissipated[s];
    const Vec3d& f = solids.force[s];
    if (!(p.clamped.active && p.clamped[i])) {
      p.velocity[i] += f * (span / p.mass[i]);
      continue;
    }
    for (int a = 0; a < 3; a++) ledger.wallImpulse[a].add(-f[a] * span);  // impulse of its constraint
    if (p.clamped[i] == driven) ledger.wallWork.add(-dot(f, p.velocity[i]) * span);
  }
}

}  // namespace

void substepSolids(World& w, Halos halos, StepTools& t, double dt) {
  const int n = w.clock.substeps;
  if (n <= 1) return;
  const double span = dt / n, far2 = w.grid.support * w.grid.support / (dt * dt);
  linkSolids(w.particles, w.solids);  // in a resumed run, rows have been sorted since the last link
  // New references are already handled.
  if (w.solids.rereferenced.active)
    std::fill_n(w.solids.rereferenced.data(), w.solids.size(), std::uint8_t{0});
  if (w.particles.stepMeanVelocity.active)
    std::fill_n(w.particles.stepMeanVelocity.data(), w.particles.owned, Vec3d{});
  findSubstepContacts(wallView(w), t.walls.substepContacts);
  drift(w, span, far2);
  for (int k = 1; k < n; k++) {
    moveWalls(w.walls, w.clock.time + k * span);
    addFastForces(w, halos, t, span);
    kick(w.particles, w.solids, w.ledger, span);
    drift(w, span, far2);
    t.times.lap(StepPhase::Drift);
  }
}

void chooseSubsteps(const Modules& modules, Clock& c, Ledger& ledger, const WallContacts& contacts,
                    double longest) {
  const int before = c.substeps, most = modules.mostSubsteps;
  const double step = nextStep(c), wanted = std::ceil(step / longest * (1 - 1e-9));
  c.substeps = wanted < most ? std::max(1, static_cast<int>(wanted)) : most;
  // The number decreases only if it is likely to stay smaller. A fluctuating number of substeps pumps energy
  // into fast oscillations, like fluctuating steps.
  if (c.substeps < before && before <= most && 1.1 * step > (before - 1) * longest) c.substeps = before;
  if (c.substeps == before) return;
  for (int a = 0; a < 3; a++) {
    ledger.wallForce[a].addProduct(contacts.fast[a], 1.0 / c.substeps);
    ledger.wallForce[a].addProduct(contacts.fast[a], -1.0 / before);
  }
}

}  // namespace thaw
