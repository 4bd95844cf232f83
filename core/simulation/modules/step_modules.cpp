// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"

#include <algorithm>
#include <span>

#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {

std::vector<StepModule> stepModules() {
  // Loads from outside come first: implicit viscosity and thermostats depend on all other forces and heat.
  return {explicitForces(),
          emitters(),
          outsideLoads(),
          solidContact(),
          bodyContact(),
          sleepOfSolids(),
          vanishingObstacles(),
          summedDensity(),
          carriedDensity(),
          shiftingInside(),
          densityMonitor(),
          flowLaws(),
          pairForces(),  // before all sums that add to its forces and heat
          pairTerms(),
          implicitViscosity(),
          exposedAreas(),  // before heatFlow, whose walls cover them
          heatFlow(),      // before melting: phases follow from the new temperatures
          heatExchange(),
          conductionCorrection(),
          contactConductance(),
          evaporation(),
          heatSources(),
          limitsOfTerms(),
          surfaceEnergy(),
          tensionByTemperature(),
          tensionByCurvature(),
          energyOfLeaving(),  // after surfaceEnergy, which adds the walls to the surface gradients
          melting(),          // before extensionPairForces, which add to PhaseEnergyWork::inPairs
          densityByPhase(),   // after melting: densities at rest follow from the new phases
          mushDrag(),
          incompressiblePressure(),
          extensionPairForces(),
          forcesAgainstShifting(),
          fracture(),       // before elasticSolids, which sends the stress
          newReferences(),  // after fracture
          elasticSolids(),
          solidSubsteps(),
          bodyForces(),
          rigidParts(),  // after elasticSolids, whose step limits it withdraws
          rigidPieces(),
          rigidBodies(),          // after melting, which sets meltedAnywhere
          energyOfPhaseChange(),  // after rigidBodies, whose pieces touch by impulses
          viscosityCorrection(),
          bodyTypes(),
          sheets(),
          orientedContact(),
          orientedBodies(),
          surfaceMotion()};
}

namespace {

/// Adds the active columns that are not in the list.
void addActive(std::span<AnyColumn* const> columns, ColumnList& list) {
  for (AnyColumn* column : columns) {
    const std::span<AnyColumn* const> present = list;
    if (column->active && std::find(present.begin(), present.end(), column) == present.end())
      list.push_back(column);
  }
}

}  // namespace

StepPhases phasesOf(World& w, const TermWork& terms) {
  StepPhases phases;
  addActive(recordColumns(w.particles), phases.ghosts.withPositions);
  for (const auto& added : w.particles.added)
    if (added->ghosts) phases.ghosts.withPositions.push_back(added.get());
  for (const StepModule& module : stepModules())
    if (module.isOn(w, terms)) {
      for (const ModuleCall& c : module.calls)
        phases.calls[static_cast<std::size_t>(c.phase)].push_back(c.call);
      const GhostColumns ghosts = module.ghosts(w.particles);
      addActive(ghosts.withPositions, phases.ghosts.withPositions);
      addActive(ghosts.withDensities, phases.ghosts.withDensities);
    }
  return phases;
}

void prepareModules(World& w, StepTools& t) {
  for (const StepModule& module : stepModules())
    if (module.isOn(w, t.terms)) module.prepare(w, t);
}

}  // namespace thaw
