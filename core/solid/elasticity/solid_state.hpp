// SPDX-License-Identifier: Apache-2.0
// Evaluation of single solids in double precision. It is used for rare events (fracture, new
// references) whose energy jump is recorded.
#pragma once
#include "core/solid/elasticity/elastic.hpp"
#include "core/solid/elasticity/moment.hpp"

namespace thaw {

/// Reference X_ij (m) and weight of bond k of a solid, for both storage forms (Bonds::vectors).
struct ReferenceBond {
  Vec3d vector;
  double weight;
};

/// Current x_ij, references X_ij and X_ji (m), and weight of bond k of a solid.
struct BondVectors {
  Vec3d current, reference, reverse;
  double weight;
};
BondVectors bondVectors(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                        std::size_t solidIndex, int k);

/// Recomputes A^-1, rank and the other bond data of one owned solid.
void refreshSolid(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t solidIndex);
/// Like refreshSolid, with the same bits, for the eight owned solids of a group at once.
/// ElasticWork::bondCount does not change. Requires: bonds without vectors.
void refreshGroup(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t group);

/// Returns grad u of one owned solid at Solids::position, completed where A is singular.
Mat3d solidGradient(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                    std::size_t solidIndex);

/// Returns the stored energy (J) of one owned solid at Solids::position: law, volume and hourglass.
double solidEnergy(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t solidIndex);
/// Stored energy of a solid at the current positions, and at those before the drift of this step.
struct DriftEnergy {
  double now, before;  ///< J
};
/// Requires: Solids::velocity of the drift (m/s) of owned and remote rows. dt: s.
DriftEnergy driftEnergy(const ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t solidIndex,
                        double dt);
/// Records the energy that a change of bonds or references removes. The half kick at the end of this step
/// uses the forces after the change, while the drift used the forces before it. Without the difference of
/// their work, the error of the energy balance would be of first order in dt.
inline void recordJump(const DriftEnergy& from, const DriftEnergy& to, ExactSum& phaseJump) {
  phaseJump.add(from.now - to.now);
  phaseJump.add(-0.5 * ((from.now - from.before) - (to.now - to.before)));
}

/// Gradient and energy of a solid.
struct SolidStrain {
  Mat3d gradU;
  double energy;
};
SolidStrain solidStrain(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                        std::size_t solidIndex);
/// Returns the same bits as solidStrain if all ends are at their reference positions (atReference), without
/// reading the bonds.
SolidStrain solidStrainAtReference(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                                   std::size_t solidIndex);
/// Returns true if every row, remote rows included, is at its reference position, as at the start of a scene.
bool atReference(const Solids& solids);

/// Constants of a solid's material at its liquid fraction.
ElasticConstants constantsOfSolid(const ElasticWork& work, const Solids& solids, std::size_t solidIndex);

}  // namespace thaw
