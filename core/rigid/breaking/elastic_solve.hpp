// SPDX-License-Identifier: Apache-2.0
// Static stress of rigid pieces under the forces of an impact, balanced by their inertia [MMDJ01].
//
// Short beams bond neighbouring particles, as in the bonded-particle model [PC04]. The length and the
// width of a beam are the spacing a. A particle has a displacement u and a rotation phi. The energy of a bond
// is
//   E a (|delta|^2 + a^2 / 12 |theta|^2) / 2,
//   delta = u_j - u_i - (phi_i + phi_j) x l / 2,   theta = phi_j - phi_i,   l = x_j - x_i.
// On the cubic lattice this is an isotropic medium with Poisson's ratio 0, and a row of particles is a beam.
// Young's modulus does not change the stress, so E a = 1 here.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fields/column.hpp"
#include "core/halo/halos.hpp"
#include "core/rigid/breaking/impacts.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Displacement and rotation, or force and moment.
struct Generalised {
  Vec3d linear{}, angular{};
};

/// Vector of the iteration over all rows, including ghosts.
struct BondedMotion : Table {
  BondedMotion() : Table("bonded motion") {
    activate(linear);
    activate(angular);
  }
  Column<Vec3d> linear{*this, "linear", "1", Keep::Transient, "displacement times the stiffness of a bond"};
  Column<Vec3d> angular{*this, "angular", "1", Keep::Transient, "rotation times the stiffness of a bond"};
};

/// The bonds of hit pieces.
struct BondedPieces {
  struct Bond {
    std::uint32_t other;  ///< row of a particle or a ghost
    Vec3d arm;            ///< m, from the particle to the other one
  };
  double spacing = 0;                 ///< m
  std::vector<std::uint32_t> pieces;  ///< rows of pieces, ascending
  std::vector<std::uint32_t> member;  ///< owned rows of their particles, ascending
  std::vector<std::uint32_t> system;  ///< by member: index in `pieces`
  std::vector<std::size_t> first;     ///< by member, and the end: its first bond
  std::vector<Bond> bonds;            ///< in the order of cells and ids

  /// Returns the index of `row` in `pieces`. Requires: `pieces` contains it.
  std::uint32_t systemOf(std::uint32_t row) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(pieces, row) - pieces.begin());
  }
  std::span<const Bond> of(std::size_t m) const {
    return std::span(bonds).subspan(first[m], first[m + 1] - first[m]);
  }
};

/// Finds the bonds of pieces. Neighbours within joinDistance are bonded. Neighbours within connectedDistance
/// are bonded if they have no common neighbour within joinDistance. Requires: Continuum::piece of ghosts.
BondedPieces bondPieces(const RigidView& view, std::span<const std::uint32_t> pieces);

/// Returns the load of each member: the forces of contacts, and the inertia that balances them.
std::vector<Generalised> balancedLoads(const RigidView& view, const BondedPieces& bonded,
                                       const ImpactLoads& loads);

/// Sets `motion` to the displacements under the loads, by conjugate gradients with exact sums for each piece.
/// Returns true if the iteration converged. Collective.
bool solveBonds(const RigidView& view, const Halos& halos, const BondedPieces& bonded,
                std::span<const Generalised> loads, BondedMotion& motion);

/// Returns the stress (Pa) of a member: the mean stress of its cell plus the bending stress at the surface of
/// its bonds.
Sym3d stressOf(const BondedPieces& bonded, std::size_t member, std::uint32_t row, const BondedMotion& motion);

/// Returns the force (N) of a bond on a particle, and the moment (N m) at the middle of the bond.
Generalised bondForce(const BondedPieces::Bond& bond, std::uint32_t row, double spacing,
                      const BondedMotion& motion);

}  // namespace thaw
