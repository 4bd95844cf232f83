// SPDX-License-Identifier: Apache-2.0
// Connects particles of rigid materials.
#pragma once
#include <functional>

#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Largest distance (spacings) between connected particles of a piece. It includes diagonal neighbours in a
/// face of the lattice, as for components of the surface.
inline constexpr double connectedDistance = 1.5;
/// Largest distance (spacings) at which a freezing particle joins a piece.
inline constexpr double joinDistance = 1.2;

/// Returns true if a particle is part of a piece or becomes one.
inline bool belongsToPiece(const Scene& scene, const Continuum& p, std::size_t i) {
  return p.phase[i] == Solid && scene.materials[p.material[i]].isRigid();
}

/// Pairs of rows that labelPieces treats as exceptions; null: none. Both functions are symmetric.
struct SpecialPairs {
  std::function<bool(std::uint32_t, std::uint32_t)> parted{};  ///< a break separates the rows
  std::function<bool(std::uint32_t, std::uint32_t)> welded{};  ///< the rows belong to two pieces that weld
};

/// Sets Continuum::setLabel of owned particles. For particles of pieces, it is 1 + the smallest id of all
/// particles connected to them, else 0. Particles are connected if they are close and of one piece (at the
/// start: of one body), or if they are welded. They are also connected if they touch and one has no piece
/// yet. Requires: ghosts. Collective.
void labelPieces(const RigidView& view, const Halos& halos, bool atStart, const SpecialPairs& special = {});

}  // namespace thaw
