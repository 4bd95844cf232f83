// SPDX-License-Identifier: Apache-2.0
// Connected particles of rigid materials.
#pragma once
#include <functional>

#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Longest distance (spacings) of connected particles of a piece: that of two neighbours across an edge of
/// the lattice, as for components of the surface.
inline constexpr double connectedDistance = 1.5;
/// Longest distance (spacings) at which a particle that freezes joins a piece.
inline constexpr double joinDistance = 1.2;

/// Returns true if a particle is part of a piece or becomes one.
inline bool belongsToPiece(const Scene& scene, const Continuum& p, std::size_t i) {
  return p.phase[i] == Solid && scene.materials[p.material[i]].isRigid();
}

/// Pairs of rows that labelPieces treats in another way; null: none. The order of the two does not matter.
struct SpecialPairs {
  std::function<bool(std::uint32_t, std::uint32_t)> parted{};  ///< a break separates the two
  std::function<bool(std::uint32_t, std::uint32_t)> welded{};  ///< rows of two pieces that weld
};

/// Sets Continuum::setLabel of owned particles that belong to pieces to 1 + the smallest id of all
/// particles connected to them, and of others to 0. Connected are particles of one piece (at the start: of
/// one body), particles in touch of which one has no piece yet, and welded ones. Requires: ghosts.
/// Collective.
void labelPieces(const RigidView& view, const Halos& halos, bool atStart, const SpecialPairs& special = {});

}  // namespace thaw
