// One slot at a time, in double: for the rare events (a bond breaks, a reference is renewed) whose energy
// jump is booked.
#pragma once
#include "core/solid/elastic.hpp"
#include "core/solid/moment.hpp"

namespace thaw {

/// Reference X_ij (m) and weight of bond k of a slot, whatever bonds hold (Bonds::vectors).
struct ReferenceBond {
  Vec3d vector;
  double weight;
};
ReferenceBond referenceBond(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                            std::size_t slot, int k);

/// Current x_ij and reference X_ij, X_ji of bond k of a slot, m, and its weight.
struct BondVectors {
  Vec3d current, reference, reverse;
  double weight;
};
BondVectors bondVectors(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot,
                        int k);

/// Recomputes A^-1, rank and what else `work` keeps of one owned slot.
void refreshSlot(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t slot);
/// The same, to the last bit, of the eight slots of a group, all of them owned, at once; not where bonds have
/// vectors. ElasticWork::bondCount stays.
void refreshGroup(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t group);

/// grad u of one owned slot from the positions in Solids::position, completed where A is singular.
Mat3d slotGradient(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot);

/// Stored energy (J) of one owned slot at the positions in Solids::position: law, volume and hourglass.
double slotEnergy(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot);
/// Both.
struct SlotStrain {
  Mat3d gradU;
  double energy;
};
SlotStrain slotStrain(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot);
/// The same bits without a look at the bonds, where all ends are at their places of the reference
/// configuration (atReference).
SlotStrain slotStrainAtReference(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                                 std::size_t slot);
/// Is every row, remote ones as well, where its reference is? So it is when a scene starts.
bool atReference(const Solids& solids);

/// Constants of a slot's material at its liquid fraction.
ElasticConstants slotConstants(const ElasticWork& work, const Solids& solids, std::size_t slot);

}  // namespace thaw
