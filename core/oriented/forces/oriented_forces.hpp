// SPDX-License-Identifier: Apache-2.0
// Interaction rules of oriented particles and their forces.
#pragma once
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Returns whether two rows belong to the same surface without a cut between them.
inline bool sameSurface(const Oriented& o, std::size_t i, std::size_t j) {
  constexpr std::uint64_t first = 0x5555555555555555ull;
  const std::uint64_t a = o.cutSides[i], b = o.cutSides[j];
  return o.group[i] == o.group[j] && ((a & first & (b >> 1)) | ((a >> 1) & first & b)) == 0;
}

/// Returns the potential of a pair. It is that of the body with the lower number, so both particles use the
/// same one.
inline const PairPotential& potentialOf(const OrientedWork& work, const Oriented& o, std::size_t i,
                                        std::size_t j) {
  return work.potentials[std::min(o.body[i], o.body[j])];
}

/// Updates ghosts and builds the neighbour lists of owned rows, with 1.1 support radii. Requires:
/// redistributed rows without ghosts. Collective.
void updateNeighbours(OrientedBodies& oriented, const Scene& scene, Halos halos, OrientedLists& lists);

/// Computes the normals of owned rows from their orientations.
void findNormals(Oriented& rows);

/// Updates positions and normals of the existing ghosts. Collective.
void refreshGhostPoses(Oriented& rows, Halos halos);

/// Computes force, torque, energy and stiffness of owned rows from pairs, obstacles, and fields at
/// OrientedWork::time, and adds Oriented::external. Records no work. Requires: current positions and
/// normals of ghosts.
void sumOrientedForces(const OrientedView& view);

/// Records impulse, work and friction loss of obstacles in a step of dt (s), from forces at the current
/// positions. Records those of fields (fields.hpp) as well. The symplectic and semi-implicit integrators
/// record the work of fields, since they determine the velocity.
void recordObstacleWork(const OrientedView& view, double dt);

}  // namespace thaw
