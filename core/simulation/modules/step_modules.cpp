// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"

namespace thaw {

std::vector<StepModule> stepModules() {
  // Loads from outside come first: implicit viscosity and thermostats answer to all other forces and heat.
  return {outsideLoads(),
          solidContact(),
          sleepOfSolids(),
          vanishingObstacles(),
          summedDensity(),
          carriedDensity(),
          shiftingInside(),
          densityMonitor(),
          implicitViscosity(),
          heatFlow(),
          contactConductance(),
          evaporation(),
          heatSources(),
          surfaceEnergy(),
          tensionByTemperature(),
          flowLaws(),
          energyOfLeaving(),
          melting(),
          densityByPhase(),
          mushDrag(),
          incompressiblePressure(),
          extensionPairForces(),
          forcesAgainstShifting(),
          elasticSolids(),
          solidSubsteps(),
          buoyancy(),
          rigidParts(),
          rigidPieces(),
          rigidBodies(),
          viscosityCorrection(),
          bodyTypes(),
          sheets(),
          orientedContact(),
          orientedBodies(),
          surfaceMotion()};
}

StepPhases phasesOf(const World& w, const StepTools& t) {
  StepPhases phases;
  for (const StepModule& module : stepModules())
    if (module.isOn(w, t))
      for (const ModuleCall& c : module.calls)
        phases.calls[static_cast<std::size_t>(c.phase)].push_back(c.call);
  return phases;
}

}  // namespace thaw
