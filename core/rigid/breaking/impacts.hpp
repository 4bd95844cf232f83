// SPDX-License-Identifier: Apache-2.0
// Impacts of rigid pieces, and their forces. The contact impulse J of an impact acts for the time 2 L / c. In
// this time, a pressure wave of speed c = sqrt(E / rho) crosses a piece of length L and returns. The force J
// c / (2 L) is exact for rods that collide end to end.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/breaking/piece_records.hpp"
#include "core/rigid/contact/find_contacts.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Pieces with fewer particles do not break.
inline constexpr std::uint64_t leastToBreak = 16;

/// Returns the sum of the magnitudes of the contact impulses (N s) of each row, over all ranks. Collective.
std::vector<double> contactSizes(const RigidView& view, std::span<const FoundContact> contacts, Reducer& all);

/// Returns the rows, ascending, of pieces that an impact may break in the step of dt (s). The contact
/// impulses of these pieces (sizes, N s) exceed twice the impulses of known loads and weight. The stress may
/// reach the strength. The result for a row is the same on all ranks that have the row.
std::vector<std::uint32_t> findHit(const RigidView& view, std::span<const double> sizes, double dt);

/// Contact forces on particles of the hit pieces.
struct ImpactLoads {
  PieceRecords records{recordWords, {}};  ///< all loads on the pieces that this rank holds
  static constexpr std::size_t recordWords = 9;
  std::uint64_t piece(std::size_t k) const { return records.at(k)[0]; }
  std::uint64_t particle(std::size_t k) const { return records.at(k)[1]; }
  Vec3d force(std::size_t k) const { return records.place(k, 3); }   ///< N
  Vec3d torque(std::size_t k) const { return records.place(k, 6); }  ///< N m, about the centre of the piece
};

/// Returns the loads of all hit pieces. Collective.
ImpactLoads impactLoads(const RigidView& view, std::span<const FoundContact> contacts,
                        std::span<const std::uint32_t> hit, Reducer& all);

}  // namespace thaw
