// SPDX-License-Identifier: Apache-2.0
// Bodies and emitters as sources of particles.
#pragma once
#include <memory>
#include <vector>

#include "core/domain/emit.hpp"
#include "core/geometry/basic/signed_distance.hpp"

namespace thaw {

struct ParticleSources {
  std::vector<std::shared_ptr<const SignedDistance>> shapes;  ///< shapes of the bodies until they are
                                                              ///< sampled; meshes are slow to make
  std::vector<EmitterPlan> emitters;
  bool emitFirst = false;  ///< the next evaluation also emits layers that leave at time 0
};

}  // namespace thaw
