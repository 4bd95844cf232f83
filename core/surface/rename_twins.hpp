// No two surfels of one id: ids of births are hashes, and a hash may be there already.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Owned rows from `first` on are new ones. Those whose id another surfel of any rank has, in this table or
/// in `others`, get a new one, a hash of the old one and of where they are, until none has: the same on any
/// number of ranks. All ranks see the new ids in pieces of 65,536, so that memory does not follow their
/// number, and look for each of their own in them; of a million births in a run one in 2e7 runs has a twin.
/// Returns how many were renamed, on all ranks. Collective.
std::int64_t renameTwins(Surfels& surfels, std::size_t first, std::uint64_t seed, Reducer& all,
                         const Surfels* others = nullptr);

}  // namespace thaw
