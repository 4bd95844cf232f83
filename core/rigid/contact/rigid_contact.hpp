// SPDX-License-Identifier: Apache-2.0
// Data that the contact solver of rigid pieces reads and returns.
#pragma once
#include <cstdint>
#include <span>

#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

/// Value of RigidContact::b for an obstacle.
inline constexpr std::uint32_t noPiece = 0xffffffffu;

/// One row of the solver: a rigid piece, or a free particle (elastic solid), which has no inertia tensor.
/// Requires: the same bits on all ranks that hold the row.
struct PieceMotion {
  double inverseMass = 0;  ///< 1/kg; 0: the motion is prescribed
  Sym3d inverseInertia{};  ///< 1/(kg m^2), world frame, about the centre; zero for a free particle
  Vec3d centre{};          ///< m
  Vec3d velocity{};        ///< m/s, of the centre
  Vec3d spin{};            ///< rad/s, world frame
};

/// Returns the velocity (m/s) of the point of a row at `arm` (m) from its centre.
inline Vec3d velocityAtArm(const PieceMotion& piece, const Vec3d& arm) {
  return piece.velocity + cross(piece.spin, arm);
}

/// Contact point. Exactly one rank holds it.
struct RigidContact {
  std::uint32_t a = 0;               ///< row
  std::uint32_t b = noPiece;         ///< row, or noPiece: an obstacle
  Vec3d armA{}, armB{};              ///< m, from the centres of a and b to the point of contact
  Vec3d normal{};                    ///< unit vector from b to a
  double gap = 0;                    ///< m, negative for overlap
  double friction = 0;               ///< 1, Coulomb's coefficient
  double restitution = 0;            ///< 1, Newton's coefficient
  double rolling = 0;                ///< m, maximum moment of rolling friction over normal force
  Vec3d otherVelocity{};             ///< m/s, of the obstacle at the point; zero for a piece
  Vec3d otherSpin{};                 ///< rad/s, of the obstacle; zero for a piece
  std::uint64_t keyA = 0, keyB = 0;  ///< particle of a; particle of b or number of the obstacle
  Vec3d impulse{};         ///< N s, on a; input: first guess, for example from the last step; output: result
  Vec3d angularImpulse{};  ///< N m s, on a, of rolling friction; input and output as for `impulse`
};

/// Returns the velocity (m/s) of side a of a contact relative to side b.
inline Vec3d relativeVelocity(const RigidContact& c, std::span<const PieceMotion> rows) {
  const Vec3d u = velocityAtArm(rows[c.a], c.armA);
  return u - (c.b == noPiece ? c.otherVelocity : velocityAtArm(rows[c.b], c.armB));
}

/// Change of a row by the solver. It is zero for pieces without contacts.
struct PieceChange {
  Vec3d impulse{};         ///< N s, sum of all contacts
  Vec3d angularImpulse{};  ///< N m s, about the centre
  Vec3d shift{};           ///< m, displacement of the centre that removes overlap; it carries no momentum
  Vec3d turn{};            ///< rad, rotation vector that removes overlap
};

}  // namespace thaw
