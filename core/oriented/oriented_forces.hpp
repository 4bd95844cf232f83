// Who acts on whom among oriented particles, and the forces that follow.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Do two rows belong to the same surface, with no cut between them?
inline bool sameSurface(const Oriented& o, std::size_t i, std::size_t j) {
  constexpr std::uint64_t first = 0x5555555555555555ull;
  const std::uint64_t a = o.cutSides[i], b = o.cutSides[j];
  return o.group[i] == o.group[j] && ((a & first & (b >> 1)) | ((a >> 1) & first & b)) == 0;
}

/// The constants of a pair: of the body with the lower number, so that both ends take the same.
inline const PairPotential& potentialOf(const OrientedWork& work, const Oriented& o, std::size_t i,
                                        std::size_t j) {
  return work.potentials[std::min(o.body[i], o.body[j])];
}

/// Copies of the rows around this rank's, and the neighbours of each owned one within a tenth more than the
/// support radius. Needs rows at home, without ghosts. Collective.
void readyOriented(World& world, Halos halos, StepTools& tools);

/// Normals of all owned rows from their orientations.
void findNormals(Oriented& rows);

/// Sends places and normals of the same ghosts again. Collective.
void refreshPlaces(World& world, Halos halos);

/// Force, torque, energy and stiffness of all owned rows, of pairs, obstacles and fields, these as they are
/// at OrientedWork::time; Oriented::external is added. Books nothing. Needs ghosts whose places and normals
/// are up to date.
void addUpForces(World& world, StepTools& tools);

/// What obstacles do in a step of dt (s): impulse, work and loss by friction, of the forces at the rows'
/// places now, into the ledger; the same of fields (fields.hpp), but for their work, which the symplectic and
/// the semi-implicit step book, as they know by what velocity they move.
void bookObstacles(World& world, const StepTools& tools, double dt);

}  // namespace thaw
