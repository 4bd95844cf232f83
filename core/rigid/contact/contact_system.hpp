// SPDX-License-Identifier: Apache-2.0
// Linear map from contact impulses to velocities of the points of contact.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/rigid/contact/fixed_sum.hpp"
#include "core/rigid/contact/piece_exchange.hpp"
#include "core/rigid/contact/rigid_contact.hpp"

namespace thaw {

/// Change of the motion of a row by impulses.
struct RowChange {
  Vec3d velocity{};  ///< m/s
  Vec3d spin{};      ///< rad/s
};

/// The contacts of a step as a linear system. It refers to the rows and contacts that it is made from.
struct ContactSystem {
  std::span<const PieceMotion> pieces;
  std::span<const RigidContact> contacts;
  PieceExchange* exchange = nullptr;
  Reducer* all = nullptr;
  std::vector<double> inertia;  ///< 1/kg, for each contact: bound of the velocity by a unit of impulse when
                                ///< the contacts of a piece share its mass [TBV12]; 0: both sides are
                                ///< prescribed
  double lever = 1;             ///< m, power of two above the largest distance of a contact from a centre
  std::vector<std::int64_t> words;  ///< scratch, rowWords for each row
  std::vector<double> unitOf;       ///< kg m/s, unit of the linear sums of each row

  static constexpr std::size_t rowWords = 12;  ///< two words for each component of impulse and angular
                                               ///< impulse
};

/// Prepares the system. Collective.
ContactSystem contactSystem(std::span<const PieceMotion> pieces, std::span<const RigidContact> contacts,
                            PieceExchange& exchange, Reducer& all);

/// Sets the units of sums for velocities up to `speed` > 0 (m/s), a bound that all ranks share.
void setSpeed(ContactSystem& system, double speed);

/// Relative velocity (m/s) of a contact that the changes of the rows add.
inline Vec3d relativeChange(const RigidContact& c, std::span<const RowChange> rows) {
  Vec3d u = rows[c.a].velocity + cross(rows[c.a].spin, c.armA);
  if (c.b != noPiece) u = u - (rows[c.b].velocity + cross(rows[c.b].spin, c.armB));
  return u;
}

/// Sums the impulses (N s) of all contacts of each row into its words, over all holders. Collective.
void sumImpulses(ContactSystem& system, std::span<const Vec3d> impulses);

/// The summed impulse and angular impulse of a row.
struct RowImpulse {
  Vec3d linear, angular;
};
RowImpulse rowImpulse(const ContactSystem& system, std::size_t row);

/// Changes of all rows by the impulses. Collective.
void applyImpulses(ContactSystem& system, std::span<const Vec3d> impulses, std::vector<RowChange>& rows);

/// Exact sums of N numbers over contacts and ranks, in units of a shared scale.
template<std::size_t N> struct ContactSums {
  FixedUnit unit;
  std::array<std::int64_t, 2 * N> words{};
  void add(std::size_t k, double x) { addFixed(&words[2 * k], x, unit); }
  void sum(Reducer& all) { all.sum(words); }
  double value(std::size_t k) const { return fixedValue(&words[2 * k], unit); }
};

}  // namespace thaw
