// Contact of solids that are not bonded: separate bodies, pieces of one body, frozen lumps.
#pragma once
#include <cstdint>
#include <vector>

#include "core/fluid/pair_sums.hpp"
#include "core/math/exact_sum.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"
#include "core/solid/solids.hpp"

namespace thaw {

/// Distance (in spacings) below which unbonded solid particles push each other away. Below 1, so that
/// neighbours on a lattice that were never bonded do not repel each other at rest.
inline constexpr double contactDistance = 0.9;

/// The part of a contact's force (N) on a row that takes energy away.
struct ContactResistance {
  std::uint32_t row = 0;
  Vec3d force;
};

struct ContactContext {
  const Scene& scene;
  const CellGrid& grid;
  const Solids& solids;
  const Bonds& bonds;
  double step;  ///< s, of the step at hand: dashpots and friction take a fifth of a pair's velocity in it at
                ///< most
  ExactSum* frozen = nullptr;  ///< Ledger::phaseJump where some particle of some rank has just frozen: what
                               ///< contacts of such make of nothing is taken from it (J)
  std::vector<ContactResistance>* resisting = nullptr;  ///< takes those of all pairs: their order is that of
                                                        ///< the list, where rows of a group take turns, so
                                                        ///< none are added up
  std::int64_t* coincident = nullptr;  ///< counts pairs at the same place, each at both ends; nullptr where
                                       ///< the sum of density does
};

/// Adds the contact forces of close pairs to owned rows, in the order of the list. Per pair: a linear spring
/// k (d0 - r) along the line of centres with k the harmonic mean of the two E * spacing, a dashpot that takes
/// energy away as the coefficient of restitution says (Cundall & Strack 1979), and Coulomb friction,
/// regularised by the same dashpot. Two at the same place have an energy but no direction: they are counted,
/// and separateCoincident moves them. Pairs that are bonded are left out, so intact solids feel nothing of
/// it. Conserves momentum; both ends compute the same force. What is dissipated is booked by the velocities
/// that the forces are found with; to the square of the step it is with what the kick around now adds
/// (bookResistance).
void addSolidContacts(const ContactContext& context, const ClosePairs& pairs, Continuum& particles);

}  // namespace thaw
