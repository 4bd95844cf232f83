// The parts of a step that deal with bonds.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Brings the table of solids up to date with the particles (BondHalo::relink) and, where anything changed on
/// any rank, what is computed from bonds alone. Collective.
void relinkSolids(World& world, Halos halos, StepTools& tools, const Relink& work);

/// Drops the bonds of what has melted in this step and books the elastic energy they held. Collective.
void melt(World& world, Halos halos, StepTools& tools);

/// The start of a scene whose bonds are their ends: until they are made nobody asks for what each step finds
/// from them (columnsOfSteps), and its memory is better taken when the lists of the start are gone and remote
/// rows are known. Where bonds have vectors, forming them looks at F of their ends.
inline bool fieldsToCome(const World& world, const StepTools& tools) {
  return tools.bondsAtStart && !world.bonds.vectors;
}

/// Copies places (velocities, liquid fractions) to the slots and sends them along the bonds.
void beginDeformation(World& world, Halos halos, const StepTools& tools);

/// Deformation, plastic flow, stress; then bonds break, form (at the start and where something froze) and
/// large plastic flow is taken into the reference. Ends with the stress on its way along the bonds.
/// Collective. Needs neighbour lists where bonds form.
void deform(World& world, Halos halos, StepTools& tools, double dt);

/// Elastic forces, onto the particles.
void addElasticForces(World& world, Halos halos, StepTools& tools, double dt);

/// Solids::energy and Solids::deformation of all owned slots as of the last evaluation, where steps do not
/// find them anyway (core/stored_energy.hpp asks).
void findElasticEnergy(World& world, const StepTools& tools);
/// The same for the particles in these rows, which are about to leave.
void findElasticEnergy(World& world, const StepTools& tools, std::span<const std::uint32_t> rows);

}  // namespace thaw
