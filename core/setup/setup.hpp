// From a scene to a world that is ready for its first step.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/setup/sample_bodies.hpp"
#include "core/step.hpp"

namespace thaw {

/// Grid, modules, walls and fields of a scene, without particles: what a fresh run and a restart share. The
/// scene must be in world.scene. Throws ShapeError or std::runtime_error (one sentence) for what cannot be
/// simulated.
void prepareWorld(World& world, StepTools& tools, const MeshLoader& load);

/// Samples the bodies (each rank its part) and gives cells to ranks by weight. Throws std::runtime_error
/// where bodies overlap and the scene does not say what then, or lie outside of the domain or in an obstacle.
/// Collective.
SamplingReport sampleWorld(World& world, Halos halos, StepTools& tools, const MeshLoader& load);

/// Forces and accelerations at time 0, the first dt, and the ledger's initial state; bonds where
/// StepTools::bondsAtStart. Again after a program has changed positions, velocities or enthalpies by hand.
/// Collective.
void takeStock(World& world, Halos halos, StepTools& tools);

/// sampleWorld, then takeStock with bonds and what the emitters let out at time 0. Collective.
SamplingReport startWorld(World& world, Halos halos, StepTools& tools, const MeshLoader& load);

/// After a restart: particles and solid records are on any rank; brings all home and makes ready for the next
/// step. Collective.
void resumeWorld(World& world, Halos halos, StepTools& tools);

/// After resumeWorld, where the scene has other coefficients than the run had until then: forces, stored
/// energies and the step anew, at the places and the time of now. What energy is stored now and was not
/// before is Ledger::restartJump. Collective.
void takeNewCoefficients(World& world, Halos halos, StepTools& tools);

}  // namespace thaw
