// SPDX-License-Identifier: Apache-2.0
// The parts of a step that involve bonds.
#pragma once
#include "core/halo/exchange.hpp"
#include "core/halo/halos.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Updates the table of solids (BondHalo::rebuildBonds) and, if anything changed on any rank, the data
/// derived from bonds. Collective.
void rebuildSolidBonds(World& world, Halos halos, StepTools& tools, const BondUpdate& work);

/// Drops the bonds of particles that melted in this step and records their elastic energy. Collective.
void melt(World& world, BondHalo& halo, ElasticWork& elastic, PhaseTimes& times);

/// Returns true at the start of a scene whose bonds have no vectors. Until the bonds exist, the fields of
/// columnsOfSteps are unused. Their memory is allocated after the lists of the start are freed and remote
/// rows are known. This does not apply to bonds with vectors, whose formation reads F of their ends.
inline bool fieldsDeferred(const Bonds& bonds, const SolidWork& work) {
  return work.bondsAtStart && !bonds.vectors;
}

/// Returns the options of an elastic evaluation in a step of dt (s).
ElasticStep elasticStep(const ElasticWork& elastic, double dt);

/// Copies positions (and velocities and liquid fractions, if active) to the solids and sends these columns
/// along the bonds. Collective.
Exchange sendPositions(const Continuum& particles, Solids& solids, const Bonds& bonds, BondHalo& halo,
                       const SolidWork& work);

/// Computes deformation, plastic flow and stress. Waits for the positions of sendPositions.
void deformSolids(World& world, Halos halos, StepTools& tools, double dt, Exchange positions);

/// Returns true if bonds form in this step on any rank: at the start, after freezing, or by welding. Welding
/// is checked at the current positions, so a restart needs no additional state. Collective.
bool bondsForm(World& world, Reducer& all, const StepTools& tools);

/// Forms bonds, and computes deformation and stress with them. Requires: neighbour lists, and no refresh of
/// ghosts in flight. Collective.
void makeBonds(World& world, Halos halos, StepTools& tools, double dt);

/// Adds elastic forces to the particles. Waits for the stress of other ranks.
void addElasticForces(World& world, ElasticWork& elastic, PhaseTimes& times, double dt, Exchange stress);

/// Computes Solids::energy and Solids::deformation of all owned solids for the last evaluation, unless steps
/// compute both (core/simulation/sums/stored_energy.hpp).
void findElasticEnergy(Solids& solids, const Bonds& bonds, const ElasticWork& elastic);
/// The same for the particles in these rows, which are about to leave.
void findElasticEnergy(const Continuum& particles, Solids& solids, const Bonds& bonds,
                       const ElasticWork& elastic, std::span<const std::uint32_t> rows);

}  // namespace thaw
