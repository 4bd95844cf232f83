// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/impulse_guess.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace thaw {
namespace {

/// Cosine of the largest angle between normals that count as one. Edges of two boxes that are flush, and the
/// corners on their faces, have contacts at the same place.
constexpr double sameNormal = 0.99;

/// Numbers of contacts, by particle, then in an order that does not depend on the ranks.
std::vector<std::size_t> byParticle(std::span<const FoundContact> contacts) {
  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t k) {
    const FoundContact& f = contacts[k];
    const RigidContact& c = f.contact;
    return std::tuple(f.particle, f.partner, c.keyB, c.gap, c.normal.x, c.normal.y, c.normal.z);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

/// Calls use(numbers) with the contacts of each particle with each partner.
template<class Use> void eachPair(std::span<const FoundContact> contacts, Use&& use) {
  const std::vector<std::size_t> order = byParticle(contacts);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const FoundContact& f = contacts[order[begin]];
    while (end < order.size() && contacts[order[end]].particle == f.particle &&
           contacts[order[end]].partner == f.partner)
      end++;
    use(std::span(order).subspan(begin, end - begin));
  }
}

/// Returns the first contact with the largest value.
template<class Value> std::size_t best(std::span<const std::size_t> numbers, Value&& value) {
  return *std::max_element(numbers.begin(), numbers.end(),
                           [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
}

bool shares(const FoundContact& a, const FoundContact& b) {
  return dot(a.contact.normal, b.contact.normal) > sameNormal;
}

}  // namespace

void guessImpulses(const Continuum& p, std::span<FoundContact> contacts) {
  eachPair(contacts, [&](std::span<const std::size_t> numbers) {
    const std::uint32_t i = contacts[numbers[0]].particle;
    if (p.contactPartner[i] != contacts[numbers[0]].partner) return;
    const std::size_t most = best(
        numbers, [&](std::size_t k) { return dot(contacts[k].contact.normal, p.contactImpulse[i]); });
    const auto sharing = [&](std::size_t k) { return k == most || shares(contacts[k], contacts[most]); };
    const double part = 1.0 / static_cast<double>(std::count_if(numbers.begin(), numbers.end(), sharing));
    for (const std::size_t k : numbers) {
      if (!sharing(k)) continue;
      contacts[k].contact.impulse = p.contactImpulse[i] * part;
      if (p.rollingImpulse.active) contacts[k].contact.angularImpulse = p.rollingImpulse[i] * part;
    }
  });
}

void keepImpulses(std::span<const FoundContact> contacts, const Pieces& pieces, Continuum& p) {
  const auto forget = [&](std::size_t i) {
    p.contactPartner[i] = 0;
    p.contactImpulse[i] = {};
    if (p.rollingImpulse.active) p.rollingImpulse[i] = {};
  };
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.piece[i] == notRigid || !pieces.asleep[p.pieceRow[i]]) forget(i);
  for (const FoundContact& f : contacts) forget(f.particle);
  eachPair(contacts, [&](std::span<const std::size_t> numbers) {
    const auto size = [&](std::size_t k) {
      return dot(contacts[k].contact.impulse, contacts[k].contact.impulse);
    };
    const FoundContact& most = contacts[best(numbers, size)];
    Vec3d sum{}, angular{};
    for (const std::size_t k : numbers)
      if (shares(contacts[k], most))
        sum += contacts[k].contact.impulse, angular += contacts[k].contact.angularImpulse;
    const std::uint32_t i = most.particle;
    if (!(dot(sum, sum) > dot(p.contactImpulse[i], p.contactImpulse[i]))) return;  // ties: the first partner
    p.contactPartner[i] = most.partner;
    p.contactImpulse[i] = sum;
    if (p.rollingImpulse.active) p.rollingImpulse[i] = angular;
  });
}

}  // namespace thaw
