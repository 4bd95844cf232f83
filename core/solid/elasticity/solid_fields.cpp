// SPDX-License-Identifier: Apache-2.0
// Activation of the fields that the solids of a scene need, and transfer between particles and solids.
#include <algorithm>

#include "core/contact/solid_contact.hpp"
#include "core/scene/phase_density.hpp"
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {
namespace {

/// Returns ElasticWork::lawLoops.
std::vector<LawLoop> lawLoopsOf(const ElasticWork& work) {
  std::vector<LawLoop> all, used;
  for (std::size_t m = 0; m < work.materials.size(); m++) {
    all.push_back(work.solidConstants[m].law->law->kernels.deformation);
    if (work.materials[m].canBeSolid()) used.push_back(all.back());
  }
  if (used.empty()) return {};
  const bool same = std::all_of(used.begin(), used.end(), [&](LawLoop loop) { return loop == used[0]; });
  if (!same) return all;
  return used[0] ? std::vector{used[0]} : std::vector<LawLoop>{};
}

}  // namespace

void activateSolidFields(Continuum& particles, Solids& solids, Bonds& bonds, ElasticWork& work,
                         const SolidSetup& setup) {
  const Scene& scene = setup.scene;
  const Modules& modules = setup.modules;
  const CellGrid& grid = setup.grid;
  work.materials = scene.materials;
  for (Material& m : work.materials) m.density = solidDensityOf(m);  // for volumes and damping of bonds
  work.precision = scene.numerics.elasticPrecision;
  work.support = scene.numerics.bondSupport * scene.spacing;
  work.rereference = scene.numerics.plasticRereference;
  work.periods = periodsOf(grid);
  work.periodic = grid.periodic[0] || grid.periodic[1] || grid.periodic[2];
  work.plastic = modules.plastic;
  work.touch = modules.contact ? contactDistance * scene.spacing : 0;
  bool rereferences = false, hardens = false, limited = false;
  for (const Material& m : work.materials) {
    work.solidConstants.push_back(elasticConstants(m, 0));
    if (!m.canBeSolid()) continue;
    if (modules.fracture) work.minBreakStretch = std::min(work.minBreakStretch, m.breakStretch);
    work.damping = work.damping || m.damping > 0;
    rereferences = rereferences || (modules.plastic && work.solidConstants.back().yield < never &&
                                    m.maxPlasticStrain > work.rereference);
    limited = limited ||
              (modules.plastic && work.solidConstants.back().yield < never && m.maxPlasticStrain < never);
    hardens = hardens || (modules.plastic && m.hardening > 0);
  }
  work.lawLoops = lawLoopsOf(work);
  // If references may change, each bond stores its own. Otherwise all bonds share the initial configuration.
  const bool vectors = modules.freezing || modules.welding || rereferences;
  bonds.choose(vectors, vectors, work.precision == Precision::Single);

  // Melting records the energy of softening particles in every step. Substeps evaluate energies at other
  // positions than the step.
  work.energyInSteps = modules.melting || modules.substeps;
  if (modules.rigidify) work.energyInSteps = true;  // passive solids keep the energy of their last evaluation
  work.deformationInSteps = work.energyInSteps || vectors || modules.sleep;

  particles.activate(particles.solidIndex);
  if (modules.freezing || modules.welding) {
    particles.activate(particles.frame);
    particles.activate(particles.justFrozen);
  }
  if (work.periodic) particles.activate(particles.unwrappedPosition);
  for (AnyColumn* c : {static_cast<AnyColumn*>(&solids.id), static_cast<AnyColumn*>(&solids.particle),
                       static_cast<AnyColumn*>(&solids.material), static_cast<AnyColumn*>(&solids.volume),
                       static_cast<AnyColumn*>(&solids.energy), static_cast<AnyColumn*>(&solids.changed)})
    solids.activate(*c);
  if (!vectors) solids.activate(solids.reference);
  if (work.plastic) solids.activate(solids.plasticInverse);
  if (limited) solids.activate(solids.lastGradient);
  if (hardens) solids.activate(solids.plasticPath);
  if (work.plastic || work.damping) solids.activate(solids.dissipated);
  if (rereferences) {
    solids.activate(solids.rereferenced);
    solids.activate(solids.referenceGradient);
  }
  if (modules.surface) solids.activate(solids.exposed);
  if (modules.melting) {
    solids.activate(solids.liquid);
    solids.activate(solids.melted);
  }
  if (modules.rigidify) solids.activate(solids.velocity);  // for strain rates
  for (AnyColumn* c : columnsOfSteps(solids, work)) solids.activate(*c);
}

std::vector<AnyColumn*> columnsOfSteps(Solids& solids, const ElasticWork& work) {
  std::vector<AnyColumn*> columns{&solids.position, &solids.momentInverse, &solids.deformation,
                                  &solids.force};
  columns.push_back(work.precision == Precision::Single ? static_cast<AnyColumn*>(&solids.end)
                                                        : &solids.endDouble);
  if (work.damping || work.minBreakStretch < never || solids.rereferenced.active)
    columns.push_back(&solids.velocity);
  if (work.damping) columns.push_back(&solids.drag);
  return columns;
}

ColumnList remoteColumnsAfterRebuild(Solids& solids) {
  if (solids.reference.active) return {&solids.material, &solids.reference};
  return {&solids.material};
}

ColumnList remoteColumnsBeforeDeformation(Solids& solids) {
  if (solids.velocity.active) return {&solids.position, &solids.velocity};
  return {&solids.position};
}

ColumnList remoteColumnsBeforeForces(Solids& solids) {
  ColumnList columns{solids.end.active ? static_cast<AnyColumn*>(&solids.end) : &solids.endDouble};
  if (solids.drag.active) columns.push_back(&solids.drag);
  if (solids.rereferenced.active) columns.push_back(&solids.rereferenced);
  return columns;
}

void takeReferences(const Continuum& particles, Solids& solids) {
  if (!solids.reference.active) return;
  for (std::size_t s = 0; s < solids.owned; s++) solids.reference[s] = particles.position[solids.particle[s]];
}

void copyToSolids(const Continuum& particles, Solids& solids) {
  for (std::size_t s = 0; s < solids.owned; s++) {
    const std::uint32_t p = solids.particle[s];
    solids.position[s] = particles.position[p];
    if (solids.velocity.active) solids.velocity[s] = particles.velocity[p];
    if (solids.liquid.active) solids.liquid[s] = particles.liquid[p];
  }
}

void fillNewSolids(const Continuum& particles, Solids& solids, const ElasticWork& work, bool atStart) {
  for (std::size_t s = 0; s < solids.owned; s++) {
    if (solids.volume[s] > 0) continue;
    solids.volume[s] = particles.mass[solids.particle[s]] / work.materials[solids.material[s]].density;
    if (solids.exposed.active) solids.exposed[s] = !atStart;
  }
}

void addSolidForces(const ElasticWork& work, const Solids& solids, Continuum& particles, double dt) {
  const bool losses = solids.dissipated.active && particles.dissipation.active && dt > 0;
  forEachAwake(work, solids, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; s++) {
      const std::uint32_t p = solids.particle[s];
      particles.force[p] += solids.force[s];
      if (losses) particles.dissipation[p] += solids.dissipated[s] / dt;
    }
  });
}

}  // namespace thaw
