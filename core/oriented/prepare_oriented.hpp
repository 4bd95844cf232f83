// SPDX-License-Identifier: Apache-2.0
// Preparation of a scene's oriented bodies.
#pragma once
#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented.hpp"
#include "core/oriented/data/oriented_work.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene_warning.hpp"

namespace thaw {

void activateOriented(Oriented& rows, const Scene& scene, const Modules& modules);

/// Computes the potentials, the area per particle (OrientedBody::cellShare), and the interpolants of given
/// points. Throws ShapeError.
void prepareOriented(Scene& scene, OrientedWork& work, const MeshLoader& load);

/// Appends this rank's particles with their constraints. Appends repairs of meshes to `warnings`. Returns the
/// positions (m) of all particles of each body, the same on all ranks. Throws ShapeError. Collective.
std::vector<std::vector<Vec3d>> sampleOriented(Oriented& rows, const Scene& scene, Halos halos,
                                               const MeshLoader& load, std::vector<SceneWarning>& warnings);

}  // namespace thaw
