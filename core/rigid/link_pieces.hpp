// SPDX-License-Identifier: Apache-2.0
// Sends the row of each piece to the ranks that need it.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Rows of particles whose pieces this rank needs.
enum class PieceUsers {
  Owned,     ///< owned particles
  AndGhosts  ///< owned particles and ghosts, whose Continuum::piece is up to date
};

/// Updates the rows of pieces to match the particles of this rank, and sets Continuum::pieceRow. Requires:
/// for each piece with particles on any rank, some rank has its row. That rank has particles of the piece, or
/// the piece is in its RigidWork::departed. Collective.
void linkPieces(const RigidView& view, const Halos& halos, PieceUsers users);

/// Copies the rows that this rank leads. Over all ranks, each piece is copied once.
void copyLedRows(const Pieces& from, Pieces& to);

}  // namespace thaw
