// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/contact_system.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/sym_eigen.hpp"

namespace thaw {
namespace {

/// Returns the velocity of a contact point per unit impulse at it, for each axis (1/kg). r: m, from the
/// centre of mass.
Mat3d pointMobility(const PieceMotion& piece, const Vec3d& r) {
  Mat3d m;
  for (int k = 0; k < 3; k++) {
    Vec3d e;
    e[k] = 1;
    m.row[k] = piece.inverseMass * e + cross(piece.inverseInertia * cross(r, e), r);
  }
  return m;
}

double largestEigenvalue(const Mat3d& m) {
  const SymEigen e = eigenOf(symmetric(m));
  return std::max({e.value[0], e.value[1], e.value[2]});
}

std::vector<std::int64_t> contactsPerRow(const ContactSystem& s) {
  std::vector<std::int64_t> count(s.pieces.size(), 0);
  for (const RigidContact& c : s.contacts) {
    count[c.a]++;
    if (c.b != noPiece) count[c.b]++;
  }
  s.exchange->sum(count, 1);
  return count;
}

double leverOf(const ContactSystem& s) {
  double lever = 0;
  for (const RigidContact& c : s.contacts) {
    lever = std::max(lever, length(c.armA));
    if (c.b != noPiece) lever = std::max(lever, length(c.armB));
  }
  s.all->maximum({&lever, 1});
  return lever > 0 && std::isfinite(lever) ? std::ldexp(1.0, std::ilogb(lever) + 1) : 1;
}

}  // namespace

ContactSystem contactSystem(std::span<const PieceMotion> pieces, std::span<const RigidContact> contacts,
                            PieceExchange& exchange, Reducer& all) {
  ContactSystem s{pieces, contacts, &exchange, &all, {}, 1, {}, {}, {}, {}};
  const std::vector<std::int64_t> count = contactsPerRow(s);
  s.inertia.reserve(contacts.size());
  for (const RigidContact& c : contacts) {
    Mat3d m = static_cast<double>(count[c.a]) * pointMobility(pieces[c.a], c.armA);
    if (c.b != noPiece) m = m + static_cast<double>(count[c.b]) * pointMobility(pieces[c.b], c.armB);
    s.inertia.push_back(largestEigenvalue(m));
  }
  for (std::size_t row = 0; row < count.size(); row++)
    if (count[row] > 0) s.touching.push_back(static_cast<std::uint32_t>(row));
  s.lever = leverOf(s);
  s.sums.resize(pieces.size());
  s.words.resize(pieces.size() * ContactSystem::rowWords);
  s.unitOf.assign(pieces.size(), 1);
  return s;
}

void setSpeed(ContactSystem& s, double speed) {
  for (std::size_t row = 0; row < s.pieces.size(); row++)
    if (s.pieces[row].inverseMass > 0)
      s.unitOf[row] = FixedUnit::forScale(speed / s.pieces[row].inverseMass).unit;
}

void clearImpulses(ContactSystem& s) {
  for (const std::uint32_t row : s.touching) s.sums[row] = {};
}

void sumImpulses(ContactSystem& s) {
  for (const std::uint32_t row : s.touching)
    for (std::size_t k = 0; k < 6; k++)
      s.sums[row].store(k, s.unitOf[row] * (k < 3 ? 1 : s.lever),
                        &s.words[row * ContactSystem::rowWords + 2 * k]);
  s.exchange->sum(s.words, ContactSystem::rowWords);
}

RowImpulse rowImpulse(const ContactSystem& s, std::size_t row) {
  const std::int64_t* words = &s.words[row * ContactSystem::rowWords];
  RowImpulse sum;
  for (int k = 0; k < 3; k++) {
    sum.linear[k] = fixedValue(words + 2 * k, s.unitOf[row]);
    sum.angular[k] = fixedValue(words + 6 + 2 * k, s.unitOf[row] * s.lever);
  }
  return sum;
}

void applyImpulses(ContactSystem& s, std::vector<RowChange>& rows) {
  sumImpulses(s);
  rows.resize(s.pieces.size());
  for (const std::uint32_t row : s.touching) {
    const RowImpulse sum = rowImpulse(s, row);
    rows[row] = {s.pieces[row].inverseMass * sum.linear, s.pieces[row].inverseInertia * sum.angular};
  }
}

}  // namespace thaw
