// SPDX-License-Identifier: Apache-2.0
// Work data of a step.
#pragma once
#include <vector>

#include "core/contact/contact_work.hpp"
#include "core/domain/particle_sources.hpp"
#include "core/flow/density/carry_work.hpp"
#include "core/flow/implicit_viscosity/viscous_work.hpp"
#include "core/flow/incompressible/pressure_work.hpp"
#include "core/fluid/laws/surface_energy.hpp"
#include "core/fluid/pair_sums/pair_sum_work.hpp"
#include "core/heat/heat_work.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/oriented/data/oriented_work.hpp"
#include "core/rigid/data/rigid_work.hpp"
#include "core/simulation/time/scene_limits.hpp"
#include "core/simulation/workspace/phase_energy.hpp"
#include "core/simulation/workspace/redistribution_work.hpp"
#include "core/simulation/workspace/step_hooks.hpp"
#include "core/simulation/workspace/step_phases.hpp"
#include "core/sleep/sleep.hpp"
#include "core/solid/solid_work.hpp"
#include "core/terms/term_work.hpp"
#include "core/time/phase_times.hpp"
#include "core/walls/wall_work.hpp"

namespace thaw {

/// Work data of a step by module, created once (core/simulation/setup/) and reused. It is not part of the
/// state: flags and values that a step leaves for the next step are recomputed after a restart.
struct StepTools {
  std::vector<LiquidMaterial> liquids;
  SceneLimits limits;
  SurfaceMeasure surface;  ///< for surface tension as an energy
  TermWork terms;
  ParticleSources sources;
  RedistributionWork redistribution;
  PairSumWork sums;
  WallWork walls;
  CarryWork carry;
  PressureWork pressure;
  ViscousWork viscous;
  HeatWork heat;
  PhaseChangeWork phaseChange;
  SolidWork solid;
  ContactWork contact;
  SleepWork sleep;
  RigidWork rigid;
  OrientedWork oriented;
  StepPhases phases;  ///< calls of the scene's modules
  StepHooks hooks;
  PhaseTimes times;
  double mass = 0;  ///< kg, of all ranks
};

}  // namespace thaw
