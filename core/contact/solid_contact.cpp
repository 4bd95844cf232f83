// SPDX-License-Identifier: Apache-2.0
#include "core/contact/solid_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/contact_pair.hpp"

namespace thaw {
namespace {

/// Returns true if two particles with a gap (m) touch within two steps. n: direction from the other particle
/// to the own one.
bool willTouch(const ContactContext& x, const Continuum& p, const ClosePair& pair, const Vec3d& n,
               double gap) {
  return !(gap > -2 * x.step * dot(p.velocity[pair.own] - p.velocity[pair.other], n)) || gap <= 0;
}

}  // namespace

void addSolidContacts(const ContactContext& x, const ClosePairs& pairs, Continuum& p) {
  const double d0 = contactDistance * x.scene.spacing;
  if (x.dissipativeForce) x.dissipativeForce->clear();
  if (x.touching) x.touching->clear();
  for (const ClosePair& pair : pairs.list) {
    const std::uint32_t i = pair.own, j = pair.other;
    if (!canTouch(p, i, j)) continue;  // pieces: core/rigid/contact/
    const Vec3d d = exactDifference(x.grid, p.position[i], p.position[j]);
    const double r = length(d);
    if (r == 0 && x.coincident) ++*x.coincident;
    if (p.body[i] != p.body[j]) continue;  // core/contact/body_contact.hpp
    if (hasBondTo(x.solids, x.bonds, p, i, j)) continue;
    if (x.near) *x.near = *x.near || willTouch(x, p, pair, d / r, r - d0);
    if (r >= d0) continue;
    const ContactPair c = contactPair(x.scene, p, i, j, x.step);
    const double k = c.stiffness;
    p.interaction[i] += 0.25 * k * (d0 - r) * (d0 - r);  // half of the pair energy
    const Vec3d u = p.velocity[i] - p.velocity[j];
    if (x.touching) x.touching->push_back({i, j, p.liquid[i], k, d0 - r, r > 0 ? -dot(u, d) / r : 0});
    if (r == 0) continue;
    const Vec3d n = d / r;
    const double un = dot(u, n), spring = k * (d0 - r);
    const double dash = std::max(-c.dashpot * un, -spring);  // a contact never pulls
    const Vec3d tangential = u - n * un;
    const double slip = length(tangential), normalForce = spring + dash;
    const double rub = slip > 0 ? std::min(c.friction * normalForce, c.frictionRate * slip) : 0;
    Vec3d dissipativeForce = n * dash;
    if (slip > 0) dissipativeForce -= tangential * (rub / slip);
    p.force[i] += n * spring + dissipativeForce;
    if (x.dissipativeForce) x.dissipativeForce->push_back({i, dissipativeForce});
    p.dissipation[i] += 0.5 * (-dash * un + rub * slip);
  }
}

bool changesStiffness(std::span<const TouchingPair> pairs, const Continuum& p) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const TouchingPair& pair) {
    return p.liquid[pair.own] != pair.liquid || p.phase[pair.own] != Solid;
  });
}

void recordStiffnessChanges(const Scene& scene, std::span<const TouchingPair> pairs, double next,
                            Continuum& p, ExactSum& phaseJump) {
  for (const TouchingPair& pair : pairs) {
    const std::uint32_t i = pair.own, j = pair.other;
    const double now = canTouch(p, i, j) ? contactStiffness(scene, p, i, j) : 0,
                 stiffer = now - pair.stiffness;
    if (stiffer == 0) continue;
    p.interaction[i] += 0.25 * stiffer * pair.overlap * pair.overlap;
    phaseJump.add(-0.25 * stiffer * pair.overlap * (pair.overlap + next * pair.growth));
  }
}

}  // namespace thaw
