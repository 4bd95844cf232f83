// SPDX-License-Identifier: Apache-2.0
// Slots whose elastic energy may change. A rigid piece keeps its shape, so the energy of a slot with all its
// bonds inside one piece is constant. Energies do not depend on rotations, so leaving out all terms of such
// slots changes neither the force nor the torque on a piece.
#pragma once
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

/// Rigid pieces of bond ends: a row for each row of Solids.
struct SlotPieces : Table {
  SlotPieces() : Table("slot piece") { activate(piece); }
  Column<std::uint64_t> piece{*this, "piece", "1", Keep::Transient,
                              "1 + smallest particle id of its rigid piece; 0: none"};
};

/// Chooses the active groups of slots: those with a slot, or a bond to a slot, that is not passive.
/// ElasticWork::held becomes 1 for passive slots, which get zero flux, hourglass stiffness and force. Slots
/// no longer passive get their Solids::deformation. Requires: pieces and Solids::position of owned and remote
/// rows, and bond data of the present bonds.
void chooseActiveSlots(ElasticWork& work, Solids& solids, const Bonds& bonds, const SlotPieces& pieces);

/// Discards the choice, since bonds or pieces changed.
inline void forgetActiveSlots(ElasticWork& work) {
  work.held.clear();
  work.sleeping = false;  // a rank that has lost all slots does not choose again
}
/// Returns true if the active slots are chosen.
inline bool activeSlotsKnown(const ElasticWork& work, const Solids& solids) {
  return work.held.size() == solids.owned;
}

/// Returns true if a slot is passive.
inline bool isPassive(const ElasticWork& work, std::size_t slot) {
  return work.sleeping && slot < work.held.size() && work.held[slot] != 0;
}

/// Returns true if some owned slot is not passive.
bool anyActiveSlot(const ElasticWork& work, const Solids& solids);

/// Sets Solids::deformation of passive slots at the present positions; else it is that of an earlier step, or
/// the identity. Requires: Solids::position of owned and remote rows.
void deformPassive(const ElasticWork& work, Solids& solids, const Bonds& bonds);

}  // namespace thaw
