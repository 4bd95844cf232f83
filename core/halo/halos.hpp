// SPDX-License-Identifier: Apache-2.0
// The halos of a step.
#pragma once
#include "core/halo/halo.hpp"

namespace thaw {

/// Communication interfaces of a step.
struct Halos {
  Reducer& all;
  CellHalo& cells;
  BondHalo& bonds;
  CellHalo* kinds[2] = {nullptr, nullptr};  ///< for further body types
                                            ///< (core/simulation/world/body_types.hpp), over the same grid;
                                            ///< null for absent types
  BondHalo* edges = nullptr;                ///< for sheets
};

}  // namespace thaw
