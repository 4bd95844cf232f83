// SPDX-License-Identifier: Apache-2.0
// Solids whose elastic energy may change. A rigid piece keeps its shape, so the energy of a solid is constant
// if all its bonds are inside one piece. Such a solid is passive. Energies do not depend on rotations, so
// omission of all terms of passive solids changes neither the force nor the torque on a piece.
#pragma once
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

/// Rigid pieces of bond ends, with a row for each row of Solids.
struct SolidPieces : Table {
  SolidPieces() : Table("solidIndex piece") { activate(piece); }
  Column<std::uint64_t> piece{*this, "piece", "1", Keep::Transient,
                              "1 + smallest particle id of its rigid piece; 0: none"};
};

/// Chooses the active groups of solids. A group is active if one of its solids, or the end of one of its
/// bonds, is not passive. ElasticWork::plasticFixed becomes 1 for passive solids, which get zero flux,
/// hourglass stiffness and force. Solids::deformation is computed for solids that are no longer passive.
/// Requires: pieces and Solids::position of owned and remote rows, and bond data of the present bonds.
void chooseActiveSolids(ElasticWork& work, Solids& solids, const Bonds& bonds, const SolidPieces& pieces);

/// Discards the choice. Call it after bonds or pieces changed.
inline void forgetActiveSolids(ElasticWork& work) {
  work.plasticFixed.clear();
  work.sleeping = false;  // reset here, since a rank that has lost all solids does not choose again
}
/// Returns true if the active solids are chosen.
inline bool activeSolidsKnown(const ElasticWork& work, const Solids& solids) {
  return work.plasticFixed.size() == solids.owned;
}

/// Returns true if a solid is passive.
inline bool isPassive(const ElasticWork& work, std::size_t solidIndex) {
  return work.sleeping && solidIndex < work.plasticFixed.size() && work.plasticFixed[solidIndex] != 0;
}

/// Returns true if some owned solid is not passive.
bool anyActiveSolid(const ElasticWork& work, const Solids& solids);

/// Sets Solids::deformation of passive solids at the present positions. Without this call it is that of an
/// earlier step, or the identity. Requires: Solids::position of owned and remote rows.
void deformPassive(const ElasticWork& work, Solids& solids, const Bonds& bonds);

}  // namespace thaw
