// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/softening.hpp"

#include <algorithm>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/materials/rest_density.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {

namespace {

bool coheresByPairs(const Numerics& n, const Modules& modules) {
  return modules.tension && n.tension == TensionForm::Pairwise;
}

/// Computes PhaseEnergyWork::energy of cohesion and of pair forces of extensions.
void findPairEnergy(World& w, StepTools& t) {
  Continuum& p = w.particles;
  PhaseEnergyWork& work = t.phaseChange.energy;
  const GroupRange all{0, w.neighbours.groups};
  work.energy.assign(p.owned, 0);
  work.force.resize(p.owned);
  work.dissipation.resize(p.owned);
  PairSums sums = pairSumsOf(w, t.sums);
  sums.interaction = work.energy.data();
  sums.force = work.force.data();
  sums.dissipation = work.dissipation.data();
  if (coheresByPairs(w.scene.numerics, w.modules)) {
    packCohesion(recordContext(w, t.liquids), p, 0, p.size(), t.sums.records);
    t.sums.kernels->tension(sums, all);
  }
  for (PairForceWork& pairs : t.terms.pairForces) {
    packPairForce(w.scene, p, 0, p.size(), pairs);
    pairs.force->kernels.sum(
        sums, {pairs.records.data(), constantsOf(w.scene, w.grid.support, pairs), work.energy.data()}, all);
  }
}

bool storesInPairs(const Numerics& n, const Modules& modules, const TermWork& terms) {
  return coheresByPairs(n, modules) || !terms.pairForces.empty();
}

}  // namespace

bool pairEnergyChanges(const World& w, const TermWork& terms, const PhaseEnergyWork& work) {
  return storesInPairs(w.scene.numerics, w.modules, terms) &&
         !std::equal(work.liquid.begin(), work.liquid.end(), w.particles.liquid.data());
}

void recordPairEnergyChange(World& w, StepTools& t) {
  if (!storesInPairs(w.scene.numerics, w.modules, t.terms)) return;
  findPairEnergy(w, t);
  for (std::size_t i = 0; i < w.particles.owned; i++) {
    const double change = t.phaseChange.energy.energy[i] - t.phaseChange.energy.inPairs[i];
    w.particles.interaction[i] += change;
    w.ledger.phaseJump.add(-change);
  }
}

void keepPairEnergy(const Continuum& p, PhaseEnergyWork& work) {
  work.ofPairs.assign(p.interaction.data(), p.interaction.data() + p.owned);
}

namespace {

/// Returns the energy (J) of compression and surface that a particle without liquid would have as liquid.
/// Requires: its sums.
double energyAsLiquid(World& w, const SurfaceMeasure& measure, const WallContacts& contacts,
                      const RecordContext& x, std::size_t i) {
  const Continuum& p = w.particles;
  double energy = 0;
  if (!w.modules.continuity) energy = compressionAt(x, p, i, 1, static_cast<double>(p.relativeDensity[i]));
  if (!w.modules.surfaceEnergy) return energy;
  const SurfaceContext surface{wallView(w), measure};
  SurfaceParticle as{static_cast<std::uint32_t>(i),
                     tensionOfParticle(surface.world, i),
                     {p.surfaceGradient[i], p.surfaceColour[i]},
                     {}};
  if (w.modules.contactAngle) as.contacts = contactsOf(contacts, as.row);
  if (as.tension > 0) energy += surfaceEnergyOf(surface, as) * restVolumeOf(p, w.scene.materials, i);
  return energy;
}

/// Returns true if a neighbour of lane l of group g is at least partly liquid. Whether other solids have sums
/// depends on the group, and thus on the number of ranks. support: m.
bool touchesLiquid(const Continuum& p, const NeighbourLists& lists, double support, std::size_t g,
                   std::size_t l) {
  const Vec3d at = p.position[lists.self[8 * g + l]];
  for (std::uint32_t n = 0; n < lists.count[g]; n++) {
    const std::uint32_t j = lists.row(g, n, l);
    if (j == lists.dummy || !(p.liquid[j] > 0)) continue;
    const Vec3d d = p.position[j] - at;
    if (dot(d, d) < support * support) return true;
  }
  return false;
}

/// Sets Continuum::softening of solid particles near liquid.
void softenSolids(World& w, const SurfaceMeasure& measure, const WallContacts& contacts,
                  const RecordContext& x) {
  Continuum& p = w.particles;
  const NeighbourLists& lists = w.neighbours;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8 && lists.fluid[g]; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy || p.liquid[i] != 0 || !w.scene.materials[p.material[i]].melts()) continue;
      const double energy = energyAsLiquid(w, measure, contacts, x, i);
      if (energy != 0 && touchesLiquid(p, lists, w.grid.support, g, l)) p.softening[i] = energy;
    }
}

}  // namespace

void beginSoftening(World& w, StepTools& t) {
  Continuum& p = w.particles;
  PhaseEnergyWork& work = t.phaseChange.energy;
  const RecordContext x = recordContext(w, t.liquids);
  const bool cohesion = coheresByPairs(w.scene.numerics, w.modules);
  if (storesInPairs(w.scene.numerics, w.modules, t.terms)) {
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
  if (w.modules.surfaceEnergy || !(w.modules.continuity || w.modules.incompressible))
    softenSolids(w, t.surface, t.walls.contacts, x);
}

}  // namespace thaw
