// SPDX-License-Identifier: Apache-2.0
// Reduction of contact patches.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/contact/find_contacts.hpp"

namespace thaw {

/// Returns the bin of a unit normal. There are 54 bins, nine on each side of a cube. Axes are in the
/// middle of bins.
std::uint32_t directionBin(const Vec3d& normal);

/// For each pair of pieces and bin of normals, keeps the deepest contact and the outermost contacts in eight
/// directions along the surface. Closed and open gaps are separate. For forces along a common normal, the
/// outline can give the same torques as the whole patch. Ranks that share a piece compare its contacts.
/// spacing: m. Collective.
void reduceContacts(std::vector<FoundContact>& contacts, const Pieces& pieces, double spacing, Reducer& all);

}  // namespace thaw
