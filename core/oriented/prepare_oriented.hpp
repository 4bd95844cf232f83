// SPDX-License-Identifier: Apache-2.0
// Preparation of a scene's oriented bodies.
#pragma once
#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halos.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

void activateOriented(World& world);

/// Computes the potentials, the area per particle (OrientedBody::cellShare), and the given points of bodies.
/// Throws ShapeError.
void prepareOriented(Scene& scene, OrientedWork& work, const MeshLoader& load);

/// Appends this rank's particles with their anchors, and repairs of meshes to `warnings`. Returns the
/// positions of all particles of each body, the same on all ranks. Throws ShapeError. Collective.
std::vector<std::vector<Vec3d>> sampleOriented(World& world, Halos halos, const MeshLoader& load,
                                               std::vector<SceneWarning>& warnings);

/// Relaxes the bodies that request it (FIRE: Bitzek et al. 2006), with growth. Stops when no force exceeds
/// 1e-9 stiffness times spacing, after OrientedBody::relax iterations, when progress stalls
/// (core/oriented/data/relax_progress.hpp), or when OrientedWork::stopRelaxing returns true on a rank.
/// Ensures: velocities are those of the scene. Returns the number of iterations. Collective.
std::int64_t relaxOriented(World& world, Halos halos, StepTools& tools);

}  // namespace thaw
