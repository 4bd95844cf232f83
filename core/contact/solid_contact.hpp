// SPDX-License-Identifier: Apache-2.0
// Contact of unbonded solids of one body, such as its pieces and frozen fragments. For different bodies see
// body_contact.hpp.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/contact/contact_pair.hpp"
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/math/exact_sum.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Distance (in spacings) below which unbonded solid particles repel each other. It is below 1, so that
/// unbonded lattice neighbours at rest do not repel.
inline constexpr double contactDistance = 0.9;

/// Distance (in spacings) below which pairs are listed in scenes whose contacts limit the step only while
/// they act (Modules::rareContact). Approaching pairs are then seen before they touch.
inline constexpr double contactSight = 0.98;

/// Unbonded solids that touch, before heat changes their phases.
struct TouchingPair {
  std::uint32_t own, other;  ///< rows
  float liquid;              ///< liquid fraction of the own particle
  double stiffness;          ///< N/m
  double overlap, growth;    ///< m, overlap; m/s, its growth
};

struct ContactContext {
  const Scene& scene;
  const CellGrid& grid;
  const Solids& solids;
  const Bonds& bonds;
  double step;  ///< s, current step; dashpots and friction remove at most a fifth of a pair's velocity in it
  std::vector<TouchingPair>* touching = nullptr;  ///< receives the pairs with an energy; null: not needed
  std::vector<DissipativeForce>* dissipativeForce = nullptr;  ///< receives the dissipative force of every
                                                              ///< pair, in list order. Forces are not summed
                                                              ///< per row, since the rows of a group
                                                              ///< alternate in the list
  std::int64_t* coincident = nullptr;  ///< counts pairs at the same position, once per end; nullptr if the
                                       ///< density sum counts them
  bool* near = nullptr;                ///< becomes true if a pair touches, or will touch within two steps
};

/// Adds the contact forces of close pairs of one body to owned rows, in list order. Each unbonded pair has
/// three forces. A linear spring k (d0 - r) acts along the line of centres, where k is the harmonic mean of
/// E * spacing of the two particles. A dashpot dissipates energy according to the coefficient of restitution
/// (CS79). Coulomb friction is regularised by the same dashpot. Coincident pairs have an energy but no
/// direction: they are counted, and separateCoincident moves them. Momentum is conserved; both ends compute
/// the same force. The dissipation uses the velocities of the force evaluation; recordResistance adds the
/// correction of second order in the step.
void addSolidContacts(const ContactContext& context, const ClosePairs& pairs, Continuum& particles);

/// Returns whether the stiffness of a pair changes with the phase of its own particle.
bool changesStiffness(std::span<const TouchingPair> pairs, const Continuum& particles);

/// Records the change of the energy of these pairs at fixed positions in phaseJump (J) and, for owned rows,
/// in Continuum::interaction. It is exact for any change of the phases. Pairs with liquid have no energy. The
/// ledger also receives the work of the next half kick, which still uses the force before the change.
/// Requires: liquid fractions and phases of ghosts. next: s, the next step.
void recordStiffnessChanges(const Scene& scene, std::span<const TouchingPair> pairs, double next,
                            Continuum& particles, ExactSum& phaseJump);

}  // namespace thaw
