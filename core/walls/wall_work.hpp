// SPDX-License-Identifier: Apache-2.0
// Work data of walls, reused in each step. They are not part of the state.
#pragma once
#include <vector>

#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/walls/tables.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct WallWork {
  WallTables tables;
  WallContacts contacts;
  std::vector<WallContact> substepContacts;  ///< solids that may touch a wall in this step
  std::vector<WallShare> shares;             ///< by owned row, with corrected viscosity
};

}  // namespace thaw
