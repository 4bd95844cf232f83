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
/// columnsOfSteps are unused. Their memory is better allocated once the lists of the start are freed and
/// remote rows are known. Forming bonds with vectors reads F of their ends.
inline bool fieldsDeferred(const Bonds& bonds, const SolidWork& work) {
  return work.bondsAtStart && !bonds.vectors;
}

/// Copies positions (velocities, liquid fractions) to the solids and sends them along the bonds. Collective.
Exchange sendPositions(const Continuum& particles, Solids& solids, const Bonds& bonds, BondHalo& halo,
                       const SolidWork& work);

/// Exchanges in flight when solids deform.
struct SolidExchanges {
  Exchange positions;   ///< from sendPositions
  Exchange& densities;  ///< ghost densities; completed early if bonds form, since that exchanges other ghosts
};

/// Computes deformation, plastic flow and stress. Then bonds break, form (at the start and after freezing),
/// and large plastic flow moves into the reference. Returns the exchange of stress along bonds. Collective.
/// Requires: neighbour lists if bonds form.
Exchange deform(World& world, Halos halos, StepTools& tools, double dt, SolidExchanges sent);

/// Adds elastic forces to the particles; waits for the stress of other ranks.
void addElasticForces(World& world, ElasticWork& elastic, PhaseTimes& times, double dt, Exchange stress);

/// Computes Solids::energy and Solids::deformation of all owned solids for the last evaluation, if steps do
/// not (core/simulation/sums/stored_energy.hpp).
void findElasticEnergy(Solids& solids, const Bonds& bonds, const ElasticWork& elastic);
/// As above for the particles in these rows, which are about to leave.
void findElasticEnergy(const Continuum& particles, Solids& solids, const Bonds& bonds,
                       const ElasticWork& elastic, std::span<const std::uint32_t> rows);

}  // namespace thaw
