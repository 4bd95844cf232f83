// SPDX-License-Identifier: Apache-2.0
// Rigid pieces: connected particles of materials with law "rigid", or rigid parts of elastic solids
// (numerics.rigidify), that move as one body. A rank has the
// rows of the pieces of its owned particles and ghosts. A row has the same bits on all ranks that have it.
#pragma once
#include <algorithm>
#include <cstdint>

#include "core/fields/column.hpp"
#include "core/math/mat3.hpp"
#include "core/math/quat.hpp"
#include "core/particles/continuum.hpp"

namespace thaw {

inline constexpr std::uint32_t noPieceRow = 0xffffffffu;

/// Table of rigid pieces. Rows ascend by id.
struct Pieces : Table {
  Pieces() : Table("piece") {}
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State, "1 + smallest id of its particles"};
  Column<double> mass{*this, "mass", "kg", Keep::State, "of all its particles"};
  Column<Vec3d> centre{*this, "centre", "m", Keep::State, "centre of mass"};
  Column<Quat> orientation{*this, "orientation", "1", Keep::State,
      "rotation from the body frame, whose axes are the principal axes"};
  Column<Vec3d> momentum{*this, "momentum", "kg m/s", Keep::State, "at the same time as the centre"};
  Column<Vec3d> angularMomentum{*this, "angularMomentum", "kg m^2/s", Keep::State,
      "about the centre, along the axes of the domain"};
  Column<Vec3d> inertia{*this, "inertia", "kg m^2", Keep::State, "principal moments"};
  Column<Vec3d> force{*this, "force", "N", Keep::State, "from the last evaluation, gravity included"};
  Column<Vec3d> torque{*this, "torque", "N m", Keep::State, "from the last evaluation, about the centre"};
  Column<Vec3d> contactImpulse{*this, "contactImpulse", "N s", Keep::State,
      "impulse of contacts, added at the start of the next step"};
  Column<Vec3d> contactTwist{*this, "contactTwist", "N m s", Keep::State,
      "angular impulse of contacts about the centre, added at the start of the next step"};
  Column<Vec3d> contactShift{*this, "contactShift", "m", Keep::State,
      "displacement out of overlaps, added to the next drift"};
  Column<Vec3d> contactTurn{*this, "contactTurn", "rad", Keep::State,
      "rotation out of overlaps, added to the next drift"};
  Column<Vec3d> pressureImpulse{*this, "pressureImpulse", "N s", Keep::State,
      "impulse of incompressible liquid, added at the start of the next step"};
  Column<Vec3d> pressureTwist{*this, "pressureTwist", "N m s", Keep::State,
      "angular impulse of incompressible liquid about the centre, added at the start of the next step"};
  Column<double> contactLoad{*this, "contactLoad", "N", Keep::State,
      "summed size of its contact impulses over the step, or half of the last value if that is larger"};
  Column<double> restTime{*this, "restTime", "s", Keep::State,
      "time since it last moved or had a load besides weight and contacts; only if pieces sleep"};
  Column<std::uint8_t> sleeping{*this, "sleeping", "1", Keep::State,
      "1: fixed in place, and without contacts with other sleeping pieces and obstacles at rest"};
  Column<std::uint64_t> count{*this, "count", "1", Keep::State, "number of its particles on all ranks"};
  Column<std::uint8_t> fixed{*this, "fixed", "1", Keep::State, "1: some of its particles are clamped"};
  Column<std::uint32_t> localParticles{*this, "localParticles", "1", Keep::Local,
      "number of its particles on this rank"};
  Column<std::uint8_t> shared{*this, "shared", "1", Keep::Local, "1: further ranks have this row"};
  Column<std::uint8_t> recordsEnergy{*this, "recordsEnergy", "1", Keep::Local,
      "1: its particle of the smallest id is on this rank, which records its energies"};
  // clang-format on

  /// Returns the row of a piece; noPieceRow if this rank does not have it.
  std::uint32_t rowOf(std::uint64_t piece) const {
    const std::uint64_t* const first = id.data();
    const std::uint64_t* const at = std::lower_bound(first, first + owned, piece);
    return at != first + owned && *at == piece ? static_cast<std::uint32_t>(at - first) : noPieceRow;
  }
};

inline void activatePieces(Pieces& p) {
  for (AnyColumn* c : p.columns) p.activate(*c);
}

/// Returns the moment of inertia (kg m^2) of a particle of this mass (kg) about its own centre. It is that of
/// a cube with an edge of the spacing (m). With it, a cube of particles has the inertia of a solid cube, and
/// a single particle has a positive inertia.
inline double ownInertia(double mass, double spacing) { return mass * spacing * spacing / 6; }

/// Returns the angular velocity (rad/s) of a piece with this angular momentum (kg m^2/s).
inline Vec3d spinOf(const Pieces& p, std::size_t row, const Vec3d& angularMomentum) {
  if (p.fixed[row]) return {};
  const Quat q = p.orientation[row];
  const Vec3d l = rotated(conjugate(q), angularMomentum), inertia = p.inertia[row];
  return rotated(q, {l.x / inertia.x, l.y / inertia.y, l.z / inertia.z});
}

/// Returns the velocity (m/s) of the centre of a piece.
inline Vec3d velocityOf(const Pieces& p, std::size_t row) {
  return p.fixed[row] ? Vec3d{} : p.momentum[row] / p.mass[row];
}

}  // namespace thaw
