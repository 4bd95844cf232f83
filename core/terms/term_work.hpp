// SPDX-License-Identifier: Apache-2.0
// Terms of a scene and the parts of its extensions that act in steps.
#pragma once
#include <vector>

#include "core/fluid/pair_sums/extension_pair_force.hpp"
#include "core/terms/field_update.hpp"
#include "core/terms/model_part.hpp"
#include "core/terms/outside_forces.hpp"

namespace thaw {

struct TermWork {
  std::vector<ActiveTerm> active;        ///< terms of the scene, in the order of their list
  std::vector<const PairSweep*> sweeps;  ///< sums of the scene's terms, in their order
  std::vector<PairForceWork> pairForces;
  std::vector<OutsideSource> outside;  ///< with Continuum::outsideForce
  std::vector<FieldUpdate> fieldUpdates;
};

}  // namespace thaw
