#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/world.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Ends a run that cannot fit before it fills the memory: compares what the particles of its bodies and the
/// surfels on them take, shared evenly by the ranks, with the memory of each machine (all of it, or what the
/// control group allows). Throws ShapeError with one sentence, alike on all ranks. The estimate is low, so
/// that nothing that fits is refused. A surface whose surfels are farther apart than half of a body's width
/// is refused likewise. Collective. shapes: of the scene's bodies.
void requireMemory(const Communicator& comm, const World& world,
                   const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

/// The same for oriented bodies and sheets, which are made while the world is prepared: to be called before
/// that. Throws ShapeError with a line for each body that cannot fit, at its place in the scene. Returns a
/// line for each body that takes a while to make. Collective.
std::vector<std::string> requireRoomForKinds(const Communicator& comm, const Scene& scene,
                                             const MeshLoader& load);

/// About how many surfels the bodies of these shapes begin with.
double expectedSurfels(const Scene& scene, const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

}  // namespace thaw
