// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Refuses a run that cannot fit into memory. Compares the memory of its particles and surfels, shared evenly
/// among ranks, with that of each machine (or the limit of its control group). The estimate is a lower bound,
/// so that no run that fits is refused. Refuses surfels farther apart than half the width of a body, too.
/// Throws ShapeError with one sentence, alike on all ranks. shapes: one per body of the scene. Collective.
void requireMemory(const Communicator& comm, const Modules& modules, const Scene& scene,
                   const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

/// Refuses oriented bodies and sheets that cannot fit into memory. Call it before the world is prepared,
/// which creates these bodies. Throws ShapeError with a line for each such body, at its place in the scene.
/// Returns a line for each body whose sampling takes a while. Collective.
std::vector<std::string> requireMemoryForBodyTypes(const Communicator& comm, const Scene& scene,
                                                   const MeshLoader& load);

/// Returns the expected number of surfels at the start of bodies of these shapes.
double expectedSurfels(const Scene& scene, const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

}  // namespace thaw
