// SPDX-License-Identifier: Apache-2.0
// Work data of contacts between solids, reused in each step. They are not part of the state.
#pragma once
#include <vector>

#include "core/contact/body_contact.hpp"
#include "core/contact/contact_pair.hpp"
#include "core/fluid/pair_sums/pair_sums.hpp"

namespace thaw {

struct ContactWork {
  ClosePairs closePairs;
  std::vector<DissipativeForce> resistance;  ///< N, contacts within a body
  BodyContactWork bodies;                    ///< between different bodies
};

}  // namespace thaw
