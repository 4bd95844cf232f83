// SPDX-License-Identifier: Apache-2.0
// Speeds and heights for the automatic sound speed: start, emitters, moving obstacles.
#pragma once
#include <memory>
#include <vector>

#include "core/domain/emit.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Returns the expected motion. It is the same on any number of ranks, and after a restart. Rotating bodies
/// and bodies with fields are sampled on their lattice, at up to 33 points per axis. Moving obstacles are
/// sampled at the corners of their bounding box, within the domain.
ExpectedMotion expectedMotion(const Scene& scene,
                              const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                              const Walls& walls, const std::vector<EmitterPlan>& emitters);

}  // namespace thaw
