// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sums/softening.hpp"

#include <algorithm>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/materials/rest_density.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {

namespace {

bool coheresByPairs(const World& w) {
  return w.modules.tension && w.scene.numerics.tension == TensionForm::Pairwise;
}

/// Computes PhaseEnergyWork::energy of cohesion and of pair forces of extensions.
void findPairEnergy(World& w, StepTools& t) {
  Continuum& p = w.particles;
  PhaseEnergyWork& work = t.phaseChange.energy;
  const GroupRange all{0, w.neighbours.groups};
  work.energy.assign(p.owned, 0);
  work.force.resize(p.owned);
  work.dissipation.resize(p.owned);
  PairSums sums = pairSumsOf(w, t);
  sums.interaction = work.energy.data();
  sums.force = work.force.data();
  sums.dissipation = work.dissipation.data();
  if (coheresByPairs(w)) {
    packCohesion(recordContext(w, t), p, 0, p.size(), t.sums.records);
    t.sums.kernels->tension(sums, all);
  }
  for (PairForceWork& pairs : t.terms.pairForces) {
    packPairForce(w.scene, p, 0, p.size(), pairs);
    pairs.force->kernels.sum(sums, {pairs.records.data(), constantsOf(w, pairs), work.energy.data()}, all);
  }
}

bool storesInPairs(const World& w, const StepTools& t) {
  return coheresByPairs(w) || !t.terms.pairForces.empty();
}

}  // namespace

bool pairEnergyChanges(const World& w, const StepTools& t) {
  return storesInPairs(w, t) && !std::equal(t.phaseChange.energy.liquid.begin(),
                                            t.phaseChange.energy.liquid.end(), w.particles.liquid.data());
}

void recordPairEnergyChange(World& w, StepTools& t) {
  if (!storesInPairs(w, t)) return;
  findPairEnergy(w, t);
  for (std::size_t i = 0; i < w.particles.owned; i++) {
    const double change = t.phaseChange.energy.energy[i] - t.phaseChange.energy.inPairs[i];
    w.particles.interaction[i] += change;
    w.ledger.phaseJump.add(-change);
  }
}

void keepPairEnergy(const World& w, StepTools& t) {
  const Continuum& p = w.particles;
  t.phaseChange.energy.ofPairs.assign(p.interaction.data(), p.interaction.data() + p.owned);
}

namespace {

/// Returns the energy (J) of compression and surface that a particle without liquid would have as liquid.
/// Requires: its sums.
double energyAsLiquid(World& w, const StepTools& t, const RecordContext& x, std::size_t i) {
  const Continuum& p = w.particles;
  double energy = 0;
  if (!w.modules.continuity) energy = compressionAt(x, p, i, 1, static_cast<double>(p.relativeDensity[i]));
  if (!w.modules.surfaceEnergy) return energy;
  const SurfaceContext surface{wallView(w), t.surface};
  SurfaceParticle as{static_cast<std::uint32_t>(i),
                     tensionOfParticle(surface.world, i),
                     {p.surfaceGradient[i], p.surfaceColour[i]},
                     {}};
  if (w.modules.contactAngle) as.contacts = contactsOf(t.walls.contacts, as.row);
  if (as.tension > 0) energy += surfaceEnergyOf(surface, as) * restVolumeOf(p, w.scene.materials, i);
  return energy;
}

/// Returns true if a neighbour of lane l of group g is liquid, if only in part. Other solids have sums or
/// not, depending on the group, and so on the number of ranks.
bool touchesLiquid(const World& w, std::size_t g, std::size_t l) {
  const Continuum& p = w.particles;
  const NeighbourLists& lists = w.neighbours;
  const Vec3d at = p.position[lists.self[8 * g + l]];
  for (std::uint32_t n = 0; n < lists.count[g]; n++) {
    const std::uint32_t j = lists.row(g, n, l);
    if (j == lists.dummy || !(p.liquid[j] > 0)) continue;
    const Vec3d d = p.position[j] - at;
    if (dot(d, d) < w.grid.support * w.grid.support) return true;
  }
  return false;
}

/// Sets Continuum::softening of solid particles near liquid.
void softenSolids(World& w, const StepTools& t, const RecordContext& x) {
  Continuum& p = w.particles;
  const NeighbourLists& lists = w.neighbours;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8 && lists.fluid[g]; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy || p.liquid[i] != 0 || !w.scene.materials[p.material[i]].melts()) continue;
      const double energy = energyAsLiquid(w, t, x, i);
      if (energy != 0 && touchesLiquid(w, g, l)) p.softening[i] = energy;
    }
}

}  // namespace

void beginSoftening(World& w, StepTools& t) {
  Continuum& p = w.particles;
  PhaseEnergyWork& work = t.phaseChange.energy;
  const RecordContext x = recordContext(w, t);
  const bool cohesion = coheresByPairs(w);
  if (storesInPairs(w, t)) {
    work.inPairs.assign(p.owned, 0);
    work.liquid.assign(p.liquid.data(), p.liquid.data() + p.owned);
  }
  for (std::size_t i = 0; i < p.owned; i++) {
    const double f = static_cast<double>(p.liquid[i]);
    p.softening[i] = 0;
    if (f == 0 && !cohesion) continue;
    double own = p.interaction[i];
    if (cohesion || w.modules.continuity) {
      const double compression = compressionOf(x, p, i, f), tension = own - compression;
      if (cohesion) work.inPairs[i] = tension;
      own = (cohesion ? 0 : tension) + (w.modules.continuity ? 0 : compression);
    }
    if (f > 0) p.softening[i] = own / f;
  }
  if (w.modules.surfaceEnergy || !(w.modules.continuity || w.modules.incompressible)) softenSolids(w, t, x);
}

}  // namespace thaw
