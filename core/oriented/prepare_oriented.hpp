// Oriented bodies of a scene, made ready.
#pragma once
#include "core/geometry/signed_distance.hpp"
#include "core/step.hpp"

namespace thaw {

/// Radius (m) within which the scene's oriented particles act on each other or on anything else: cells are at least as long.
double orientedReach(const Scene& scene);

void activateOriented(World& world);

/// Appends this rank's share of the particles. Throws SceneProblems as sampleBodies does. Collective.
void sampleOriented(World& world, Halos halos, const MeshLoader& load);

}  // namespace thaw
