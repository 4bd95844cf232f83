// SPDX-License-Identifier: Apache-2.0
// Modules of the step, with their calls in the phases of a step. A scene without a module makes none of its
// calls.
#pragma once
#include <string_view>
#include <vector>

#include "core/simulation/workspace/step_phases.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"
#include "core/terms/term_work.hpp"

namespace thaw {

struct ModuleCall {
  ModulePhase phase;
  PhaseCall call;
};

struct StepModule {
  std::string_view name;
  bool (*isOn)(const World&, const TermWork&);  ///< requires a prepared world; constant over a run
  std::vector<ModuleCall> calls;                ///< at most one per phase
  /// Ghost columns that its sums read, in addition to those of records (recordColumns). Inactive columns are
  /// ignored.
  GhostColumns (*ghosts)(Continuum&) = [](Continuum&) { return GhostColumns{}; };
  /// Sets constants of the run, once, in a world with shapes, walls, liquids and active fields.
  void (*prepare)(World&, StepTools&) = [](World&, StepTools&) {};
};

// The functions are in the order of stepModules().
StepModule explicitForces();
StepModule emitters();
StepModule outsideLoads();
StepModule solidContact();
StepModule bodyContact();
StepModule sleepOfSolids();
StepModule vanishingObstacles();
StepModule summedDensity();
StepModule carriedDensity();
StepModule shiftingInside();
StepModule densityMonitor();
StepModule flowLaws();
StepModule pairForces();
StepModule pairTerms();
StepModule implicitViscosity();
StepModule exposedAreas();
StepModule heatFlow();
StepModule heatExchange();
StepModule conductionCorrection();
StepModule contactConductance();
StepModule evaporation();
StepModule heatSources();
StepModule limitsOfTerms();
StepModule surfaceEnergy();
StepModule tensionByTemperature();
StepModule tensionByCurvature();
StepModule energyOfLeaving();
StepModule melting();
StepModule densityByPhase();
StepModule mushDrag();
StepModule incompressiblePressure();
StepModule extensionPairForces();
StepModule forcesAgainstShifting();
StepModule fracture();
StepModule newReferences();
StepModule elasticSolids();
StepModule solidSubsteps();
StepModule bodyForces();
StepModule rigidParts();
StepModule rigidPieces();
StepModule rigidBodies();
StepModule energyOfPhaseChange();
StepModule viscosityCorrection();
StepModule bodyTypes();
StepModule sheets();
StepModule orientedContact();
StepModule orientedBodies();
StepModule surfaceMotion();

/// Returns all modules. In each phase they are called in this order.
std::vector<StepModule> stepModules();

/// Returns the calls and ghost columns of the scene's modules. Requires: active fields.
StepPhases phasesOf(World& world, const TermWork& terms);

/// Calls `prepare` of the modules that the scene has. Requires: as phasesOf.
void prepareModules(World& world, StepTools& tools);

}  // namespace thaw
