// SPDX-License-Identifier: Apache-2.0
// The halos of a step.
#pragma once
#include "core/halo/halo.hpp"
#include "core/particles/body_types.hpp"

namespace thaw {

/// Communication interfaces of a step.
struct Halos {
  Reducer& all;
  CellHalo& cells;
  BondHalo& bonds;
  CellHalo* bodyTypes[bodyTypeCount] = {};  ///< over the same grid; null for absent types
  BondHalo* edges = nullptr;                ///< for sheets
};

}  // namespace thaw
