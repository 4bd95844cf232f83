// SPDX-License-Identifier: Apache-2.0
// Brings the row of each piece to the ranks that need it.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Rows whose pieces this rank needs.
enum class PieceUsers {
  Owned,     ///< owned particles
  AndGhosts  ///< owned particles and ghosts, whose Continuum::piece is up to date
};

/// Makes the rows of pieces match the particles of this rank, and sets Continuum::pieceRow. Requires: for
/// each piece with particles on some rank, a rank has its row. It has particles of the piece, or listed it in
/// RigidWork::departed. Collective.
void linkPieces(const RigidView& view, const Halos& halos, PieceUsers users);

/// Copies the rows that this rank leads: each piece once over all ranks.
void copyLedRows(const Pieces& from, Pieces& to);

}  // namespace thaw
