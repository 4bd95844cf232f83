// SPDX-License-Identifier: Apache-2.0
// Work data of elastic solids and their bonds, reused in each step. They are not part of the state.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

struct SolidWork {
  ElasticWork elastic;
  std::vector<BondRequest> requests;
  std::vector<std::uint32_t> rebonded;  ///< rows of particles with new bonds
  bool bondsAtStart = false;            ///< the next evaluation makes the initial bonds
  double maxStretch2 = 1;               ///< squared largest stretch of this rank
};

}  // namespace thaw
