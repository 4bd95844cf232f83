// SPDX-License-Identifier: Apache-2.0
// The phases of a step in which modules act (core/simulation/modules/).
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/fields/column.hpp"

namespace thaw {

struct StepContext;  // core/simulation/step_context.hpp

/// Phases in their order. The step's own lines run between them (step.cpp, evaluate.cpp, reduce_step.cpp).
enum class ModulePhase {
  // Prediction
  BeforeMotion,    ///< all data, including obstacles, is at the end of the last step
  FirstKick,       ///< before the first half kick, v += a dt/2
  Drift,           ///< after the drift, x += v dt
  ObstaclesMoved,  ///< obstacles are at the end of the step
  // Redistribution
  Emission,       ///< ghosts are gone: new particles are added
  Leaving,        ///< rows beyond open sides are listed: further particles that vanish
  Migrated,       ///< particles are on the ranks of their cells (RedistributionWork::migration), not sorted
  Redistributed,  ///< particles are on the ranks of their cells, sorted
  WallContacts,   ///< contacts of particles with walls are known
  // Density
  GhostsSent,     ///< ghosts are being sent
  BeforeDensity,  ///< rates are cleared; only with a search of neighbours
  InnerRows,      ///< before the sums of rows without ghosts among their neighbours; only with a search
  BoundaryRows,   ///< before the sums of the other rows, with ghosts present; only with a search
  DensitySums,    ///< sums of densities over neighbours of StepContext::rows: inner rows, then boundary rows
  Density,        ///< sums over neighbours are known: densities, normals, viscosities
  // Forces
  Deformation,     ///< densities are being sent to ghosts: strain and stress of solids
  NewBonds,        ///< densities have arrived; only if bonds form on some rank (StepContext::bondsForm)
  Stress,          ///< bonds of this step are known: fracture, new references, stress
  ForceSums,       ///< sums of forces over neighbours of StepContext::rows: inner rows, then boundary rows
  ContinuumForce,  ///< pair forces are known: further forces of the continuum
  Contact,         ///< contacts of solids
  Coupling,        ///< wall forces are known: forces between body types
  AllForces,       ///< forces between particles are known: loads from outside, heat flows, implicit forces
  // Integration
  SecondKick,   ///< before the second half kick
  Kicked,       ///< after the second half kick
  PhaseChange,  ///< heat, melting, freezing
  // Time-step reduction
  Limits,        ///< step limits of this rank's particles are known
  CommonLimits,  ///< limits of all ranks are known
  NextStep,      ///< the length of the next step is known
  EndOfStep      ///< preparation of the next step; last phase
};
inline constexpr std::size_t phaseCount = static_cast<std::size_t>(ModulePhase::EndOfStep) + 1;

/// Columns of ghosts that the sums of modules read.
struct GhostColumns {
  ColumnList withPositions{};  ///< known at the start of an evaluation
  ColumnList withDensities{};  ///< follow from the first sums: densities, shear rates, normals, contacts
};

using PhaseCall = void (*)(StepContext&);

/// The calls of a scene's modules and the ghosts that they need, found once in set-up (phasesOf,
/// core/simulation/modules/step_modules.hpp).
struct StepPhases {
  std::array<std::vector<PhaseCall>, phaseCount> calls;
  GhostColumns ghosts;  ///< active columns, each once
  void run(ModulePhase phase, StepContext& context) const {
    for (const PhaseCall call : calls[static_cast<std::size_t>(phase)]) call(context);
  }
};

}  // namespace thaw
