// SPDX-License-Identifier: Apache-2.0
#include "core/contact/solid_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/dashpot.hpp"
#include "core/materials/contact_modulus.hpp"
#include "core/particles/elastic_pieces.hpp"

namespace thaw {
namespace {

bool bonded(const ContactContext& x, const Continuum& p, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t slot = p.slot[i];
  if (slot == noSlot) return false;
  const bool here = j < p.owned;  // then bonds refer to its slot, and no id is read
  const std::uint32_t other = here ? p.slot[j] : noSlot;
  if (here && other == noSlot) return false;
  for (int k = 0; k < x.bonds.capacity; k++) {
    const std::uint32_t n = x.bonds.neighbour[x.bonds.at(slot, k)];
    if ((here ? n == other : x.solids.id[n] == p.id[j]) && x.bonds.hasBond(slot, k)) return true;
  }
  return false;
}

/// Exactly antisymmetric difference of two positions. Positions of periodic images are shifted already.
Vec3d between(const CellGrid& g, const Vec3d& a, const Vec3d& b) {
  Vec3d d;
  for (int k = 0; k < 3; k++)
    d[k] = static_cast<double>(static_cast<std::int32_t>(fixedPoint(g, a[k], k) - fixedPoint(g, b[k], k))) *
           (g.support / fixedUnitsPerSupport);
  return d;
}

/// Returns true if two particles with a gap (m), along the direction n from the other to the own, touch
/// within two steps.
bool willTouch(const ContactContext& x, const Continuum& p, const ClosePair& pair, const Vec3d& n,
               double gap) {
  return !(gap > -2 * x.step * dot(p.velocity[pair.own] - p.velocity[pair.other], n)) || gap <= 0;
}

struct Elastic {
  double stiffness;              ///< N/m
  double restitution, friction;  ///< 1
};

Elastic elasticOf(const Scene& s, const Continuum& p, std::uint32_t row) {
  const Material& m = s.materials[p.material[row]];
  const double f = p.liquid.active ? static_cast<double>(p.liquid[row]) : 0;
  const double modulus = contactModulus(m, f), least = 0.01 * contactModulus(m, 0);
  return {std::max(modulus, least) * s.spacing, m.restitution, m.friction};
}

struct ElasticPair {
  Elastic a, b;
  double stiffness;  ///< N/m
};

ElasticPair elasticPairOf(const Scene& s, const Continuum& p, std::uint32_t i, std::uint32_t j) {
  ElasticPair e{elasticOf(s, p, i), elasticOf(s, p, j), 0};
  // A rigid particle counts as stiff as its elastic partner, so that the step limit of contacts holds.
  if (touchesAsPiece(p, i)) e.a.stiffness = e.b.stiffness;
  if (touchesAsPiece(p, j)) e.b.stiffness = e.a.stiffness;
  e.stiffness = 2 * e.a.stiffness * e.b.stiffness / (e.a.stiffness + e.b.stiffness);
  return e;
}

bool canTouch(const Continuum& p, std::uint32_t i, std::uint32_t j) {
  return p.phase[i] == Solid && p.phase[j] == Solid && !(touchesAsPiece(p, i) && touchesAsPiece(p, j));
}

/// Half of the energy (J) of a spring that begins to act in a step: as overlap and growth in it are those of
/// a TouchingPair, the force does the work of its half kick only.
double energyThatAppears(const TouchingPair& pair, double dt) {
  return 0.25 * pair.stiffness * pair.overlap * (pair.overlap - dt * pair.growth);
}

/// Records a new contact of a particle that just froze, and lists the pair if its stiffness may change.
void recordTouch(const ContactContext& x, const Continuum& p, TouchingPair pair) {
  if (x.frozen && (p.justFrozen[pair.own] || p.justFrozen[pair.other]))
    x.frozen->add(-energyThatAppears(pair, x.step));
  if (!x.touching) return;
  pair.liquid = p.liquid[pair.own];
  x.touching->push_back(pair);
}

}  // namespace

void addSolidContacts(const ContactContext& x, const ClosePairs& pairs, Continuum& p) {
  const double d0 = contactDistance * x.scene.spacing;
  if (x.dissipativeForce) x.dissipativeForce->clear();
  if (x.touching) x.touching->clear();
  for (const ClosePair& pair : pairs.list) {
    const std::uint32_t i = pair.own, j = pair.other;
    if ((touchesAsPiece(p, i) && touchesAsPiece(p, j)) || bonded(x, p, i, j))
      continue;  // pieces: core/rigid/contact/
    const Vec3d d = between(x.grid, p.position[i], p.position[j]);
    const double r = length(d);
    if (x.near) *x.near = *x.near || willTouch(x, p, pair, d / r, r - d0);
    if (r >= d0) continue;
    const auto [a, b, k] = elasticPairOf(x.scene, p, i, j);
    p.interaction[i] += 0.25 * k * (d0 - r) * (d0 - r);  // half of the pair energy
    const Vec3d u = p.velocity[i] - p.velocity[j];
    recordTouch(x, p, {i, j, 0, k, d0 - r, r > 0 ? -dot(u, d) / r : 0});
    if (r == 0) {
      if (x.coincident) ++*x.coincident;
      continue;
    }
    const Vec3d n = d / r;
    const double mass = p.mass[i] * p.mass[j] / (p.mass[i] + p.mass[j]);
    // Restitutions near 0 are overdamped, and a particle can touch five others. Beyond this bound the
    // dashpots would add energy.
    const double most = 0.2 * mass / x.step;
    const double c = std::min(2 * dashpotRatio(std::min(a.restitution, b.restitution)) * std::sqrt(k * mass),
                              most);
    const double un = dot(u, n), spring = k * (d0 - r);
    const double dash = std::max(-c * un, -spring);  // a contact never pulls
    const Vec3d tangential = u - n * un;
    const double slip = length(tangential), normalForce = spring + dash;
    const double cut = std::min(std::sqrt(k * mass), most);  // the scale of the dashpot: friction stops
                                                             // sliding without reversing it
    const double rub = slip > 0 ? std::min(std::min(a.friction, b.friction) * normalForce, cut * slip) : 0;
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
    const double now = canTouch(p, i, j) ? elasticPairOf(scene, p, i, j).stiffness : 0,
                 stiffer = now - pair.stiffness;
    if (stiffer == 0) continue;
    p.interaction[i] += 0.25 * stiffer * pair.overlap * pair.overlap;
    phaseJump.add(-0.25 * stiffer * pair.overlap * (pair.overlap + next * pair.growth));
  }
}

}  // namespace thaw
