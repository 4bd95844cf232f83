// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"

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
          rigidParts(),  // after elasticSolids: it withdraws their step limits
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

StepPhases phasesOf(const World& w, const TermWork& terms) {
  StepPhases phases;
  for (const StepModule& module : stepModules())
    if (module.isOn(w, terms))
      for (const ModuleCall& c : module.calls)
        phases.calls[static_cast<std::size_t>(c.phase)].push_back(c.call);
  return phases;
}

}  // namespace thaw
