// SPDX-License-Identifier: Apache-2.0
// Keeps surfel ids unique: ids of births are hashes and may exist already.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface.hpp"

namespace thaw {

/// Replaces duplicate ids. Owned rows from `first` on are new. A new row may have the id of another surfel
/// of any rank, in this table or in `others`. Its id is then replaced by a hash of id and position. This
/// repeats until all are unique. The result is the same on any number of ranks. New ids are exchanged in
/// chunks of 65,536 to bound memory. A million births have a duplicate with a probability of 5e-8. Returns
/// the number of replaced ids on all ranks. Collective.
std::int64_t makeIdsUnique(Surfels& surfels, std::size_t first, std::uint64_t seed, Reducer& all,
                           const Surfels* others = nullptr);

}  // namespace thaw
