// SPDX-License-Identifier: Apache-2.0
// Search for the contacts of rigid pieces with each other and with obstacles.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/rigid/contact/element_pairs.hpp"
#include "core/rigid/contact/rigid_contact.hpp"
#include "core/rigid/data/pieces.hpp"
#include "core/scene/scene.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct ContactSearch {
  const Scene& scene;
  const CellGrid& grid;
  const Continuum& particles;  ///< with ghosts: id, position, material, phase, piece and the fields of faces
  const CellTable& cells;      ///< with ghost cells
  const Pieces& pieces;
  const Walls& walls;
  double step;  ///< s, next step
};

/// Contact with its pieces and particles.
struct FoundContact {
  RigidContact contact;
  std::uint64_t pieceA = 0;    ///< piece of a
  std::uint64_t partner = 0;   ///< piece of b, or obstacleBit | index of the wall
  std::uint32_t particle = 0;  ///< owned row of the particle of a
  std::uint32_t other = 0;     ///< row of the particle of b, or a ghost
};

inline constexpr std::uint64_t obstacleBit = std::uint64_t{1} << 63;

/// Returns true if a particle is at the surface of its piece.
inline bool hasSurface(const Continuum& p, std::size_t i) {
  return p.piece[i] != notRigid && p.faceOffset[i] > 0;
}

/// Returns the surface element of a particle in the scene. Requires: Continuum::pieceRow.
PlacedElement placedElement(const Continuum& particles, const Pieces& pieces, std::size_t row,
                            double spacing);

/// Returns the contacts that may close within the step, each on the rank that owns `particle`. motion:
/// motions of all rows of pieces, as input of the solver. Contact patches between two pieces are reduced to
/// their outline, which supports the same forces and torques. Sleeping pieces have contacts only with awake
/// pieces and moving obstacles. First guesses come from guessImpulses. Collective.
std::vector<FoundContact> findContacts(const ContactSearch& search, std::span<const PieceMotion> motion,
                                       Reducer& all);

/// Sets first guesses. A particle may have several contacts with one partner. The stored impulse goes to the
/// contact with the best aligned normal. If every contact received it, the impulses of wedged pieces would
/// grow from step to step.
void guessImpulses(const Continuum& particles, std::span<FoundContact> contacts);

/// Stores the solved impulses in the particles, as first guesses for the next step. Particles of sleeping
/// pieces keep their stored impulses.
void keepImpulses(std::span<const FoundContact> contacts, const Pieces& pieces, Continuum& particles);

}  // namespace thaw
