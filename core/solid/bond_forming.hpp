// Which particles get bonded, and with what reference: at the start, when liquid freezes, when solids weld.
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/scene/scene.hpp"
#include "core/solid/weight.hpp"

namespace thaw {

enum class BondRule {
  Start,     ///< all solid particles of the same body, at rest: X = x
  Freezing,  ///< pairs of which at least one has just frozen (Continuum::justFrozen), of one body or of
             ///< materials that weld
  Welding    ///< as Freezing, and pairs of old particles of materials that weld, once closer than `touch`, of
             ///< different bodies (or see selfWeld)
};

struct BondForming {
  BondRule rule = BondRule::Start;
  double support = 0;     ///< m, bonds are shorter
  double touch = 0;       ///< m, for Welding
  bool selfWeld = false;  ///< pieces of one body weld too, unless their material breaks: a crack does not
                          ///< heal by closing
  Periods periods;
  const std::vector<Material>* materials = nullptr;
};

/// What a bond needs to know of particles, kept at the particles because slots are renumbered:
/// Continuum::frame (F of the particle's slot at the last phase 1; the identity if it has just frozen or has
/// no slot yet) where it is active, and Continuum::home with periodic sides. When something froze: set
/// justFrozen and phase, prepareBondForming, relink (makes the slots), refresh bondFormingColumns on ghosts,
/// formBonds, relink with the requests, refreshReference.
void prepareBondForming(Continuum& particles, const Solids& solids);
/// The columns of ghosts that formBonds reads, beside position.
ColumnList bondFormingColumns(Continuum& particles);

/// x_ij in the frame of an end with this F: F^-1 x, so that a bond made now does not change F. Where F is
/// nearly singular or inverted (det F < 0.05), x itself.
Vec3d referenceIn(const Mat3d& frame, const Vec3d& x);

/// True if some owned particle is about to weld with an old solid neighbour: the step in which formBonds with
/// BondRule::Welding has something to do though nothing froze. Needs id, body, material, phase and position
/// of ghosts.
bool touchesToWeld(const Continuum& particles, const Solids& solids, const Bonds& bonds,
                   const NeighbourLists& lists, const BondForming& forming);

/// Groups [first, last) of the neighbour lists: a particle is in one of them.
struct ListedGroups {
  std::size_t first = 0, last = SIZE_MAX;
};

/// Appends the requests for bonds of owned particles with a slot to solid neighbours (owned or ghosts), in
/// the order of the neighbour lists; both ends ask for the same bond with the same bits. Pairs that are
/// bonded already are left out. Returns the number of welds: bonds between different bodies, each counted at
/// its end with the smaller id.
std::int64_t formBonds(const Continuum& particles, const Solids& solids, const Bonds& bonds,
                       const NeighbourLists& lists, const BondForming& forming,
                       std::vector<BondRequest>& requests, ListedGroups range = {});
/// The same by BondRule::Start where a bond is its other end alone.
void pairAtStart(const Continuum& particles, const NeighbourLists& lists, const BondForming& forming,
                 std::vector<BondPair>& pairs, ListedGroups range);

}  // namespace thaw
