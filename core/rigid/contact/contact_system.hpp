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
  std::vector<std::uint32_t> touching;  ///< rows with contacts on some rank
  std::vector<double> unitOf;           ///< kg m/s, unit of the linear sums of each row
  std::vector<FixedSums<6>> sums;       ///< for each row, from contacts of this rank: impulse and angular
                                        ///< impulse
  std::vector<std::int64_t> words;      ///< the same over all holders, rowWords for each row

  static constexpr std::size_t rowWords = 12;  ///< two words for each component
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

/// Begins the sums of impulses.
void clearImpulses(ContactSystem& system);

/// Adds the impulse (N s) of a contact to the sums of its rows.
inline void addImpulse(ContactSystem& s, const RigidContact& c, const Vec3d& impulse) {
  const auto add = [&](std::size_t row, const Vec3d& arm, const Vec3d& j) {
    const Vec3d twist = cross(arm, j);
    const double unit = s.unitOf[row], turn = unit * s.lever;
    s.sums[row].add({j.x, j.y, j.z, twist.x, twist.y, twist.z}, {unit, unit, unit, turn, turn, turn});
  };
  add(c.a, c.armA, impulse);
  if (c.b != noPiece) add(c.b, c.armB, -impulse);
}

/// Sums the added impulses over all holders of each row. Collective.
void sumImpulses(ContactSystem& system);

/// The summed impulse and angular impulse of a row.
struct RowImpulse {
  Vec3d linear, angular;
};
RowImpulse rowImpulse(const ContactSystem& system, std::size_t row);

/// Changes of all rows by the added impulses. Collective.
void applyImpulses(ContactSystem& system, std::vector<RowChange>& rows);

/// Exact sums of N numbers over contacts and ranks, in units of a shared scale.
template<std::size_t N> struct ContactSums {
  double units[N];
  FixedSums<N> here{};
  std::array<std::int64_t, 2 * N> words{};

  explicit ContactSums(FixedUnit unit) { std::fill_n(units, N, unit.unit); }
  void add(const double (&terms)[N]) { here.add(terms, units); }
  void sum(Reducer& all) {
    for (std::size_t k = 0; k < N; k++) here.store(k, units[k], &words[2 * k]);
    all.sum(words);
  }
  double value(std::size_t k) const { return fixedValue(&words[2 * k], units[k]); }
};

}  // namespace thaw
