// SPDX-License-Identifier: Apache-2.0
// Sites where no surface particle may be created: inside obstacles and inside solids.
#pragma once
#include "core/halo/halo.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Candidate position of a new particle of an oriented body.
struct BirthSite {
  std::size_t body = 0;
  Vec3d place{};     ///< m
  double apart = 0;  ///< m, smallest allowed distance from obstacles
};

/// Returns for each site of this rank whether it is blocked: by an obstacle closer than `apart`, or by a
/// solid continuum body. While surfaces relax, rows may lie outside of their rank's cells. All ranks
/// therefore test the sites of all ranks, and the result does not depend on the number of ranks. Requires:
/// current walls, and cells of the owned particles. Collective.
std::vector<char> blockedSites(const OrientedView& view, const std::vector<BirthSite>& places, Reducer& all);

}  // namespace thaw
