// SPDX-License-Identifier: Apache-2.0
// Selection of pairs to bond and their references: at the start, on freezing, and on welding.
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/scene/scene.hpp"
#include "core/solid/bonds/weight.hpp"

namespace thaw {

enum class BondRule {
  Start,     ///< all solid particles of the same body, at rest: X = x
  Freezing,  ///< pairs with at least one particle that just froze (Continuum::justFrozen), of one body or of
             ///< weldable materials
  Welding    ///< as Freezing, and also pairs of older particles of weldable materials closer than `touch`, if
             ///< the bodies differ or selfWeld is true
};

struct BondForming {
  BondRule rule = BondRule::Start;
  double support = 0;      ///< m, upper limit of bond lengths
  double touch = 0;        ///< m, distance below which particles weld
  double touchBodies = 0;  ///< m, distance below which particles of different bodies weld
  bool selfWeld = false;   ///< pieces of one body weld too, unless their material breaks, since cracks do not
                           ///< heal by closing
  Periods periods;
  const std::vector<Material>* materials = nullptr;
};

/// Sets the particle fields that bonds need. These are fields of particles, since solids get renumbered.
/// Continuum::frame is set if it is active, and Continuum::unwrappedPosition with periodic sides. The frame
/// is F of the solid at the last phase 1. It is the identity if the particle just froze or has no row in
/// Solids yet. The order after freezing: set justFrozen and phase, prepareBondForming, rebuildBonds (makes
/// the solids), refresh bondFormingColumns on ghosts, formBonds, rebuildBonds with the requests,
/// refreshReference.
void prepareBondForming(Continuum& particles, const Solids& solids);
/// Returns the ghost columns that formBonds reads in addition to position.
ColumnList bondFormingColumns(Continuum& particles);

/// Returns F^-1 x_ij, the distance vector (m) in the frame of an end with this F. A new bond with this
/// reference does not change F. If F is nearly singular or inverted (det F < 0.05), returns x_ij itself.
Vec3d referenceIn(const Mat3d& frame, const Vec3d& x);

/// Tables that the search for bonds reads.
struct BondSearch {
  const Continuum& particles;
  const Solids& solids;
  const Bonds& bonds;
  const NeighbourLists& lists;
};

/// Returns true if an owned particle can weld to an older solid neighbour. formBonds with BondRule::Welding
/// is then needed even if nothing froze. Requires: id, body, material, phase and position of ghosts.
bool touchesToWeld(const BondSearch& tables, const BondForming& forming);

/// Groups [first, last) of the neighbour lists; each particle is in one group.
struct ListedGroups {
  std::size_t first = 0, last = SIZE_MAX;
};

/// Appends requests for bonds of owned solid particles to solid neighbours (owned or ghosts), in the
/// order of the neighbour lists. Both ends request the same bond with the same bits. Bonded pairs are
/// skipped. Returns the number of welds. A weld is a bond between different bodies; it is counted at the end
/// with the smaller id.
std::int64_t formBonds(const BondSearch& tables, const BondForming& forming,
                       std::vector<BondRequest>& requests, ListedGroups range = {});
/// Like formBonds with BondRule::Start, for bonds without vectors (Bonds::vectors).
void pairAtStart(const Continuum& particles, const NeighbourLists& lists, const BondForming& forming,
                 std::vector<BondPair>& pairs, ListedGroups range);

}  // namespace thaw
