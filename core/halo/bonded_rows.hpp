// SPDX-License-Identifier: Apache-2.0
// Continuum particles as rows that bonds can connect.
#pragma once
#include "core/halo/halo.hpp"
#include "core/particles/elastic_pieces.hpp"

namespace thaw {

/// Returns the rows of continuum particles. Pieces of rigid materials have no bonds. Rigid parts of elastic
/// solids keep their bonds.
inline BondedRows bondedRows(Continuum& p) {
  BondedRows rows(p);
  if (piecesAreElastic(p)) rows.piece = nullptr;
  return rows;
}

}  // namespace thaw
