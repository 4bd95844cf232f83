// Oriented bodies of a scene, made ready.
#pragma once
#include "core/geometry/signed_distance.hpp"
#include "core/kinds/start_warnings.hpp"
#include "core/step.hpp"

namespace thaw {

/// Radius (m) within which the scene's oriented particles act on each other or on anything else, and a tenth:
/// cells are at least as long.
double orientedReach(const Scene& scene);

void activateOriented(World& world);

/// Constants of the potentials, the area of a particle (OrientedBody::cellShare), and points that bodies are
/// to go through. Throws ShapeError.
void prepareOriented(Scene& scene, OrientedWork& work, const MeshLoader& load);

/// Appends this rank's share of the particles, held ones with their anchors, and what was mended of meshes to
/// `warnings`. Returns the places of all particles of each body, the same on all ranks. Throws ShapeError.
/// Collective.
std::vector<std::vector<Vec3d>> sampleOriented(World& world, Halos halos, const MeshLoader& load,
                                               std::vector<SceneWarning>& warnings);

/// Moves all bodies that ask for it to rest (FIRE: Bitzek et al. 2006), growing where they grow, until no
/// force is above 1e-9 stiffness times spacing, for OrientedBody::relax iterations, until it gets nowhere
/// (core/oriented/relax_progress.hpp), or until OrientedWork::stopRelaxing says so on some rank. Velocities
/// are then those of the scene. Returns the iterations done. Collective.
std::int64_t relaxOriented(World& world, Halos halos, StepTools& tools);

}  // namespace thaw
