// SPDX-License-Identifier: Apache-2.0
// Set-up of a world from a scene, ready for its first step.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/simulation/setup/sample_bodies.hpp"
#include "core/simulation/step.hpp"

namespace thaw {

/// Prepares grid, modules, walls and fields of a scene, without particles. New runs and restarts both use it.
/// Requires: world.scene is set. Throws ShapeError or std::runtime_error (one sentence) if the scene cannot
/// be simulated.
void prepareWorld(World& world, StepTools& tools, const MeshLoader& load);

/// Samples the bodies (each rank samples a part) and assigns cells to ranks by weight. Throws
/// std::runtime_error if bodies overlap without a rule in the scene, lie outside the domain, or lie in an
/// obstacle. Collective.
SamplingReport sampleWorld(World& world, Halos halos, StepTools& tools, const MeshLoader& load);

/// Computes forces and accelerations at time 0, the first dt, and the ledger's initial state. Makes bonds if
/// SolidWork::bondsAtStart is set. Call it again after a program has changed positions, velocities or
/// enthalpies. Collective.
void initializeForces(World& world, Halos halos, StepTools& tools);

/// Changes the sampled particles of this rank before the start.
using ParticleChange = std::function<void(Continuum&)>;

/// Calls sampleWorld and `change`, relaxes oriented bodies, then calls initializeForces with bonds and the
/// particles emitted at time 0. Collective.
SamplingReport startWorld(World& world, Halos halos, StepTools& tools, const MeshLoader& load,
                          const ParticleChange& change = {});

/// Resumes a run after a restart. Particles and solid records may be on any rank. They are migrated and
/// sorted, and the next step is prepared. Collective.
void resumeWorld(World& world, Halos halos, StepTools& tools);

/// Call it after resumeWorld if the scene's coefficients differ from those of the run so far. Recomputes
/// forces, stored energies and the step at the current positions and time. The change of stored energy is
/// recorded in Ledger::restartJump. Collective.
void applyNewCoefficients(World& world, Halos halos, StepTools& tools);

}  // namespace thaw
