// SPDX-License-Identifier: Apache-2.0
// Reduction of patches of contact.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/contact/find_contacts.hpp"

namespace thaw {

/// Bin of a unit normal: 54 bins, nine on each side of a cube, with axes in the middles of bins.
std::uint32_t directionBin(const Vec3d& normal);

/// Keeps the deepest contact of each pair of pieces and bin of normals, and those that are outermost in eight
/// directions along the surface. Closed and open gaps are separate. Forces along a common normal have
/// the same torques from the outline as from the whole patch. Ranks that share a piece compare its contacts.
/// spacing: m. Collective.
void reduceContacts(std::vector<FoundContact>& contacts, const Pieces& pieces, double spacing, Reducer& all);

}  // namespace thaw
